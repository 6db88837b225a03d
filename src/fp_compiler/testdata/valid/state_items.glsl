#version 120
uniform vec4 arb_param[2];
void main() {
  vec4 s1 = vec4(gl_BackMaterial.shininess, 0.0, 0.0, 1.0);
  vec4 s3 = vec4(gl_LightSource[1].spotDirection, gl_LightSource[1].spotCosCutoff);
  vec4 s4 = vec4(normalize(normalize(gl_LightSource[2].position.xyz) + vec3(0.0, 0.0, 1.0)), 1.0);
  vec4 s5 = vec4(gl_LightSource[3].constantAttenuation, gl_LightSource[3].linearAttenuation, gl_LightSource[3].quadraticAttenuation, gl_LightSource[3].spotExponent);
  vec4 s6 = vec4(gl_LightModel.ambient.rgb * gl_BackMaterial.ambient.rgb + gl_BackMaterial.emission.rgb, gl_BackMaterial.diffuse.a);
  vec4 s8 = vec4(gl_DepthRange.near, gl_DepthRange.far, gl_DepthRange.diff, 1.0);
  vec4 s17 = vec4(gl_Fog.density, gl_Fog.start, gl_Fog.end, 1.0 / (gl_Fog.end - gl_Fog.start));
  vec4 t0;
  t0 = gl_FrontMaterial.ambient * s1.xxxx + gl_LightSource[0].position;
  t0 = s3 * s4 + t0;
  t0 = s5 * s6 + t0;
  t0 = arb_param[0] * s8.zzzz + t0;
  t0.x = dot(gl_ModelViewMatrixInverse[0], t0);
  t0.y = dot(gl_ModelViewMatrixInverse[3], t0);
  t0.z = dot(arb_param[1], t0);
  t0.w = dot(gl_TextureMatrix[1][0], t0);
  t0 = t0 * gl_Fog.color;
  gl_FragColor = t0 * s17.wwww + gl_ModelViewProjectionMatrixInverseTranspose[3];
}
