#version 120
uniform vec4 arb_vparam[10];
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  vec4 t4;
  t3.x = arb_sum(arb_vparam[0] * gl_Vertex);
  t3.y = arb_sum(arb_vparam[1] * gl_Vertex);
  t3.z = arb_sum(arb_vparam[2] * gl_Vertex);
  t3.w = arb_sum(arb_vparam[3] * gl_Vertex);
  t0.x = arb_sum(arb_vparam[4].xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t0.y = arb_sum(arb_vparam[5].xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t0.z = arb_sum(arb_vparam[6].xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t0.w = arb_sum(t0.xyz * t0.xyz);
  t0.w = inversesqrt(abs(t0.w));
  t0.xyz = t0.xyz * t0.www;
  t1.x = arb_sum(t0.xyz * arb_vparam[7].xyz);
  t2.y = max(t1.x, 0.0);
  t2 = t2.yyyy * arb_vparam[8];
  t4 = t2 + arb_vparam[9];
  gl_Position = t3;
  gl_FrontColor = t4;
  gl_TexCoord[0] = gl_MultiTexCoord0;
}
