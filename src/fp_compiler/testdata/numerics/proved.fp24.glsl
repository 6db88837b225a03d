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
float arb_colour(float x) {
  float unit = (x > 0.0 ? min(x, 1.0) : 0.0) * 4095.0, low = floor(unit), over = unit - low;
  bool up = over > 0.5 || over == 0.5 && (int(low) & 1) == 1;
  return arb_round((up ? low + 1.0 : low) * 0.00024420026);
}
vec2 arb_colour(vec2 a) { return vec2(arb_colour(a.x), arb_colour(a.y)); }
vec3 arb_colour(vec3 a) { return vec3(arb_colour(a.x), arb_colour(a.y), arb_colour(a.z)); }
vec4 arb_colour(vec4 a) { return vec4(arb_colour(a.x), arb_colour(a.y), arb_colour(a.z), arb_colour(a.w)); }
float arb_mulz(float z, float x) { return (z == 0.0) ? 0.0 : z * x; }
vec2 arb_mulz(vec2 a, vec2 b) { return vec2(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y)); }
vec3 arb_mulz(vec3 a, vec3 b) { return vec3(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z)); }
vec4 arb_mulz(vec4 a, vec4 b) { return vec4(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z), arb_mulz(a.w, b.w)); }
float arb_sum(vec3 p) { return arb_round(arb_round(p.x + p.y) + p.z); }
float arb_sum(vec3 p, float w) { return arb_round(arb_sum(p) + w); }
float arb_sum(vec4 p) { return arb_sum(p.xyz, p.w); }
void main() {
  vec4 i0 = arb_colour(gl_Color);
  vec4 i1 = arb_round(gl_TexCoord[1]);
  vec4 i2 = arb_colour(gl_SecondaryColor);
  vec4 i3 = arb_round(gl_TexCoord[2]);
  vec4 t0;
  vec4 t1;
  t0.xyz = arb_round(i0.xyz * vec3(0.0, 1.0, 0.5));
  t1.xyz = clamp(arb_round(arb_round(i1.xyz * vec3(2.0)) + t0.xyz), 0.0, 1.0);
  t0.xyz = arb_round(arb_round(t1.xyz * i0.xyz) + arb_round(arb_round(1.0 - t1.xyz) * i2.xyz));
  t0.w = arb_sum(arb_round(t0.xyz * t1.xyz));
  t1.xyz = arb_round(arb_mulz(t0.xyz, i3.xyz));
  t1.w = arb_round(arb_mulz(t0.w, i3.w));
  gl_FragColor = arb_round(arb_round(t1 * vec4(0.25)) + t0);
}
