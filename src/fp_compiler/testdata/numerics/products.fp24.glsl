#version 120
#extension GL_EXT_gpu_shader4 : require
#extension GL_ARB_shader_bit_encoding : require
uniform vec4 arb_param[1];
uniform sampler2D arb_tex0;
float arb_round(float x) {
  int bits = floatBitsToInt(x), size = bits & 0x7FFFFFFF;
  int near = (size + 63 + (size >> 7 & 1)) & -128;
  near = size >= 0x5F7FFFC0 ? (size > 0x7F800000 ? size : 0x7F800000)
                            : near < 0x20800000 ? 0 : near;
  return intBitsToFloat(bits ^ size | near);
}
vec2 arb_round(vec2 a) { return vec2(arb_round(a.x), arb_round(a.y)); }
vec3 arb_round(vec3 a) { return vec3(arb_round(a.x), arb_round(a.y), arb_round(a.z)); }
vec4 arb_round(vec4 a) { return vec4(arb_round(a.x), arb_round(a.y), arb_round(a.z), arb_round(a.w)); }
float arb_truncate(float x) {
  int bits = floatBitsToInt(x), size = bits & 0x7FFFFFFF;
  int less = size >= 0x5F800000 ? (size >= 0x7F800000 ? size : 0x5F7FFF80)
                                : size < 0x20800000 ? 0 : size & -128;
  return intBitsToFloat(bits ^ size | less);
}
vec2 arb_truncate(vec2 a) { return vec2(arb_truncate(a.x), arb_truncate(a.y)); }
vec3 arb_truncate(vec3 a) { return vec3(arb_truncate(a.x), arb_truncate(a.y), arb_truncate(a.z)); }
vec4 arb_truncate(vec4 a) { return vec4(arb_truncate(a.x), arb_truncate(a.y), arb_truncate(a.z), arb_truncate(a.w)); }
float arb_mul(float a, float b) { float p = a * b; return p != p && (a == 0.0 || b == 0.0) ? 0.0 : p; }
vec2 arb_mul(vec2 a, vec2 b) { return vec2(arb_mul(a.x, b.x), arb_mul(a.y, b.y)); }
vec3 arb_mul(vec3 a, vec3 b) { return vec3(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z)); }
vec4 arb_mul(vec4 a, vec4 b) { return vec4(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z), arb_mul(a.w, b.w)); }
float arb_sum(vec3 p) { return arb_round(arb_round(p.x + p.y) + p.z); }
float arb_sum(vec3 p, float w) { return arb_round(arb_sum(p) + w); }
float arb_sum(vec4 p) { return arb_sum(p.xyz, p.w); }
float arb_pow(float a, float b) {
  float power = arb_round(exp2(arb_round(arb_mul(b, arb_round(log2(a))))));
  return b == 0.0 ? 1.0 : a > 0.0 ? power : 0.0;
}
void main() {
  vec4 i0 = arb_round(gl_TexCoord[0]);
  vec4 s0 = arb_truncate(arb_param[0]);
  vec4 t0;
  vec4 t1;
  t0 = arb_round(texture2D(arb_tex0, i0.xy));
  t1 = arb_round(arb_mul(t0, s0));
  t0 = arb_round(arb_round(arb_mul(t1, i0)) + t0);
  t1.x = arb_sum(arb_round(arb_mul(t0.xyz, s0.xyz)));
  t1.y = arb_sum(arb_round(arb_mul(t0, s0)));
  t1.z = arb_sum(arb_round(arb_mul(t0.xyz, s0.xyz)), s0.w);
  t0.xyz = arb_round(arb_round(arb_mul(s0.xyz, t1.xyz)) + arb_round(arb_mul(arb_round(1.0 - s0.xyz), i0.xyz)));
  t1.xyz = arb_round((arb_round(arb_mul(t0.yzx, s0.zxy)) - arb_round(arb_mul(t0.zxy, s0.yzx))));
  t1.w = arb_pow(1.0, s0.y);
  t0.xyz = vec3(1.0, max(t1.x, 0.0), (t1.x > 0.0 ? arb_pow(t1.y, clamp(t1.w, -127.9990234375, 127.9990234375)) : 0.0));
  t0.w = arb_round(1.0 / t1.x);
  gl_FragColor = arb_round(arb_mul(t0, t1));
}
