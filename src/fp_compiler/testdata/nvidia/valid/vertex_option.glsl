#version 120
uniform vec4 arb_vparam[16];
attribute vec4 arb_attrib6;
vec4 arb_array0(int i) { return i >= 0 && i < 16 ? arb_vparam[i] : vec4(0.0); }
int arb_address(float x) { return abs(x) < 1073741824.0 ? int(floor(x)) : -1073741824; }
void main() {
  vec4 t0;
  vec4 t2;
  vec4 t3;
  vec4 t4;
  vec4 t5;
  vec4 t6;
  vec4 t19;
  vec4 t20;
  vec4 t21;
  int a1 = 0;
  float arb_clip2 = 0.0;
  t4.y = floor(arb_attrib6.y);
  t5.y = float(t4.y == t4.y);
  t6.y = -t5.y < 0.0 ? t4.y : 0.0;
  a1 = arb_address(t6.y);
  t21 = arb_array0(a1 + 2);
  t0 = t21;
  t4.x = float(0.0 >= t0.x);
  t19.x = t4.x;
  t20.x = 1.0 - t4.x;
  t5 = vec4(lessThan(vec4(0.0), t0));
  t6 = vec4(lessThan(t0, vec4(0.0)));
  t4 = t5 - t6;
  t0 = -t20.x < 0.0 ? t4 : t0;
  t4.x = cos(t0.x);
  t0.x = -t20.x < 0.0 ? t4.x : t0.x;
  t4.y = sin(t0.y);
  t0.y = -t20.x < 0.0 ? t4.y : t0.y;
  t20.x = t20.x + t19.x;
  t2 = -t20.x < 0.0 ? t0 : vec4(0.0, 0.0, 0.0, 1.0);
  t3.x = -t20.x < 0.0 ? t0.x : 0.0;
  gl_Position = gl_Vertex;
  gl_FrontColor = t2;
  arb_clip2 = t3.x;
}
