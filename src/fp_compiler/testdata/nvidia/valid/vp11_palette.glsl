#version 120
uniform vec4 arb_vparam[96];
attribute vec4 arb_attrib1;
vec4 arb_array0(int i) { return i >= 0 && i < 96 ? arb_vparam[i] : vec4(0.0); }
int arb_address(float x) { return abs(x) < 1073741824.0 ? int(floor(x)) : -1073741824; }
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  vec4 t4;
  vec4 t5;
  vec4 t7;
  vec4 t8;
  vec4 t9;
  vec4 t11;
  vec4 t12;
  vec4 t13;
  int a0 = 0;
  gl_Position = ftransform();
  t7.x = floor(arb_attrib1.x);
  t8.x = float(t7.x == t7.x);
  t9.x = -t8.x < 0.0 ? t7.x : 0.0;
  a0 = arb_address(t9.x);
  t13 = arb_array0(a0 + 12);
  t0 = t13;
  t13 = arb_array0(a0 - 2);
  t1 = t13;
  t7.x = 1.0 / t0.w;
  t8.x = min(t7.x, t0.w);
  t9.x = abs(t7.x);
  t11.x = min(t9.x, 1.8446744e+19);
  t12.x = max(t11.x, 5.421011e-20);
  t2.x = t8.x < 0.0 ? -t12.x : t12.x;
  t3 = abs(t1);
  t4.x = arb_sum(gl_Vertex.xyz * t3.xyz, t3.w);
  t5 = t0 - t4.xxxx;
  gl_FrontColor = t5;
  gl_FogFragCoord = t2.x;
}
