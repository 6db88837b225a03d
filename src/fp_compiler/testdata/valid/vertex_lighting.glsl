#version 120
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  vec4 s8 = vec4(normalize(normalize(gl_LightSource[0].position.xyz) + vec3(0.0, 0.0, 1.0)), 1.0);
  vec4 s9 = vec4(gl_FrontMaterial.shininess, 0.0, 0.0, 1.0);
  vec4 s10 = vec4(gl_LightSource[0].diffuse.rgb * gl_FrontMaterial.diffuse.rgb, gl_FrontMaterial.diffuse.a);
  vec4 s11 = vec4(gl_LightModel.ambient.rgb * gl_FrontMaterial.ambient.rgb + gl_FrontMaterial.emission.rgb, gl_FrontMaterial.diffuse.a);
  vec4 s12 = vec4(gl_LightSource[0].specular.rgb * gl_FrontMaterial.specular.rgb, gl_FrontMaterial.specular.a);
  vec4 t0;
  vec4 t1;
  vec4 t2;
  gl_Position.x = arb_sum(gl_ModelViewProjectionMatrixTranspose[0] * gl_Vertex);
  gl_Position.y = arb_sum(gl_ModelViewProjectionMatrixTranspose[1] * gl_Vertex);
  gl_Position.z = arb_sum(gl_ModelViewProjectionMatrixTranspose[2] * gl_Vertex);
  gl_Position.w = arb_sum(gl_ModelViewProjectionMatrixTranspose[3] * gl_Vertex);
  t0.x = arb_sum(gl_ModelViewMatrixInverse[0].xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t0.y = arb_sum(gl_ModelViewMatrixInverse[1].xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t0.z = arb_sum(gl_ModelViewMatrixInverse[2].xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t1.x = arb_sum(t0.xyz * gl_LightSource[0].position.xyz);
  t1.y = arb_sum(t0.xyz * s8.xyz);
  t1.w = s9.x;
  t2.yz = vec2(max(t1.x, 0.0), (t1.x > 0.0 ? (clamp(t1.w, -127.99999, 127.99999) != 0.0 && t1.y > 0.0 ? pow(t1.y, clamp(t1.w, -127.99999, 127.99999)) : float(clamp(t1.w, -127.99999, 127.99999) == 0.0)) : 0.0));
  t0.xyz = t2.yyy * s10.xyz + s11.xyz;
  gl_FrontColor.xyz = t2.zzz * s12.xyz + t0.xyz;
  gl_FrontColor.w = gl_FrontMaterial.diffuse.w;
  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;
}
