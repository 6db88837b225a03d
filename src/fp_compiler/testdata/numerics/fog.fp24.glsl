#version 120
#extension GL_EXT_gpu_shader4 : require
#extension GL_ARB_shader_bit_encoding : require
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
float arb_colour(float x) {
  float unit = (x > 0.0 ? min(x, 1.0) : 0.0) * 4095.0, low = floor(unit), over = unit - low;
  bool up = over > 0.5 || over == 0.5 && (int(low) & 1) == 1;
  return arb_round((up ? low + 1.0 : low) * 0.00024420026);
}
vec2 arb_colour(vec2 a) { return vec2(arb_colour(a.x), arb_colour(a.y)); }
vec3 arb_colour(vec3 a) { return vec3(arb_colour(a.x), arb_colour(a.y), arb_colour(a.z)); }
vec4 arb_colour(vec4 a) { return vec4(arb_colour(a.x), arb_colour(a.y), arb_colour(a.z), arb_colour(a.w)); }
float arb_mul(float a, float b) { return (a == 0.0 || b == 0.0) ? 0.0 : a * b; }
vec2 arb_mul(vec2 a, vec2 b) { return vec2(arb_mul(a.x, b.x), arb_mul(a.y, b.y)); }
vec3 arb_mul(vec3 a, vec3 b) { return vec3(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z)); }
vec4 arb_mul(vec4 a, vec4 b) { return vec4(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z), arb_mul(a.w, b.w)); }
float arb_mulz(float z, float x) { return (z == 0.0) ? 0.0 : z * x; }
vec2 arb_mulz(vec2 a, vec2 b) { return vec2(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y)); }
vec3 arb_mulz(vec3 a, vec3 b) { return vec3(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z)); }
vec4 arb_mulz(vec4 a, vec4 b) { return vec4(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z), arb_mulz(a.w, b.w)); }
void main() {
  vec4 i0 = arb_colour(gl_Color);
  vec4 s0 = arb_truncate(gl_FrontMaterial.diffuse);
  vec4 i1 = arb_round(vec4(gl_FogFragCoord, 0.0, 0.0, 1.0));
  vec4 s1 = arb_truncate(vec4(-gl_Fog.scale, gl_Fog.end * gl_Fog.scale, gl_Fog.density * -1.442695041, gl_Fog.density * 1.201122409));
  vec4 s2 = arb_truncate(gl_Fog.color);
  vec4 t0;
  vec4 t1;
  t0 = arb_round(arb_mulz(i0, s0));
  t1.x = arb_round(arb_mul(i1.x, s1.w));
  t1.x = arb_round(arb_mul(t1.x, t1.x));
  t1.x = clamp(arb_round(exp2(-t1.x)), 0.0, 1.0);
  t0 = clamp(t0, 0.0, 1.0);
  t0.xyz = arb_round(arb_round(t1.xxx * t0.xyz) + arb_round(arb_mulz(arb_round(1.0 - t1.xxx), s2.xyz)));
  gl_FragColor = t0;
}
