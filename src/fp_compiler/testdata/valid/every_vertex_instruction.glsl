#version 120
uniform vec4 arb_vparam[3];
vec4 arb_array0(int i) { return i >= 0 && i < 3 ? arb_vparam[i] : vec4(0.0); }
int arb_address(float x) { return abs(x) < 1073741824.0 ? int(floor(x)) : -1073741824; }
vec4 arb_log(float x) {
  float m = abs(x), l = log2(m), e = 0.0;
  if (!(m > 0.0 && m <= 3.4028235e38)) return vec4(l, 1.0, l, 1.0);
  if (m >= 18446744073709551616.0) { m *= 5.421010862427522e-20; e += 64.0; }
  if (m >= 4294967296.0) { m *= 2.3283064365386963e-10; e += 32.0; }
  if (m >= 65536.0) { m *= 0.0000152587890625; e += 16.0; }
  if (m >= 256.0) { m *= 0.00390625; e += 8.0; }
  if (m >= 16.0) { m *= 0.0625; e += 4.0; }
  if (m >= 4.0) { m *= 0.25; e += 2.0; }
  if (m >= 2.0) { m *= 0.5; e += 1.0; }
  if (m < 1.0842021724855044e-19) { m *= 18446744073709551616.0; e += -64.0; }
  if (m < 4.656612873077393e-10) { m *= 4294967296.0; e += -32.0; }
  if (m < 0.000030517578125) { m *= 65536.0; e += -16.0; }
  if (m < 0.0078125) { m *= 256.0; e += -8.0; }
  if (m < 0.125) { m *= 16.0; e += -4.0; }
  if (m < 0.5) { m *= 4.0; e += -2.0; }
  if (m < 1.0) { m *= 2.0; e += -1.0; }
  return vec4(e, m, l, 1.0);
}
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  int a0 = 0;
  t0 = abs(gl_Vertex);
  t1 = t0 + vec4(-0.25, 0.5, -1.0, -2.0);
  a0 = arb_address(t1.y);
  t2.x = arb_sum(t0.xyz * t1.xyz);
  t2.y = arb_sum(t0 * t1);
  t2.z = arb_sum(t0.xyz * t1.xyz, t1.w);
  t2.w = t1.w;
  t0.x = exp2(t2.x);
  t0.y = fract(t2.y);
  t0.zw = floor(t2.zw);
  t1.xy = fract(t0.zw);
  t1.xyz = vec3(1.0, max(t1.x, 0.0), (t1.x > 0.0 ? (clamp(t1.w, -127.99999, 127.99999) != 0.0 && t1.y > 0.0 ? pow(t1.y, clamp(t1.w, -127.99999, 127.99999)) : float(clamp(t1.w, -127.99999, 127.99999) == 0.0)) : 0.0));
  t1.w = arb_log(t0.y).w;
  t3 = arb_array0(a0 - 1);
  t2 = t0 * t3 + t1;
  t2.xy = max(t2.xy, vec2(0.0));
  t3.zw = arb_array0(a0).zw;
  t2.zw = min(t2.zw, t3.zw);
  t0.x = t2.w;
  t0 = t0 * t2;
  t1.x = (t2.y != 0.0 && t0.x > 0.0 ? pow(t0.x, t2.y) : float(t2.y == 0.0));
  t1.y = 1.0 / t2.z;
  t1.z = inversesqrt(abs(t2.w));
  t2 = vec4(greaterThanEqual(t0, t1));
  t0.xyz = vec3(lessThan(t2.xyz, t1.yxw));
  t0.xyz = t0.xyz - t2.xyz;
  t2.xyz = cross(t0.xyz, vec3(-t0.x, 1.0, 0.0));
  gl_Position = t2;
  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;
}
