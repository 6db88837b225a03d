#version 120
uniform sampler1D arb_tex0;
void main() {
  vec4 s0 = vec4(normalize(normalize(gl_LightSource[0].position.xyz) + vec3(0.0, 0.0, 1.0)), 1.0);
  vec4 t0;
  vec4 t1;
  t0.w = dot(gl_TexCoord[0].xyz, gl_TexCoord[0].xyz);
  t0.w = inversesqrt(abs(t0.w));
  t0.xyz = gl_TexCoord[0].xyz * t0.www;
  t1.x = dot(t0.xyz, s0.xyz);
  t1.x = max(t1.x, 0.0);
  t1 = texture1D(arb_tex0, t1.x);
  gl_FragColor = t1 * gl_FrontMaterial.diffuse;
}
