#version 120
#extension GL_EXT_gpu_shader4 : require
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_shader_texture_lod : require
uniform vec4 arb_param[3];
uniform sampler2D arb_tex0;
float arb_nearest(float x) {
  float low = floor(x), over = x - low;
  return over > 0.5 || over == 0.5 && (int(low) & 1) == 1 ? low + 1.0 : low;
}
int arb_half(float x) {
  int bits = floatBitsToInt(x), size = bits & 0x7FFFFFFF, sign = bits >> 16 & 0x8000;
  if (size > 0x7F800000) return sign | 0x7FFF;
  if (size >= 0x477FF000) return sign | 0x7C00;
  if (size < 0x38800000) return sign | int(arb_nearest(abs(x) * 16777216.0));
  return sign | (size + 0xFFF + (size >> 13 & 1) - 0x38000000) >> 13;
}
float arb_single(int h) {
  int sign = (h & 0x8000) << 16, size = h & 0x7FFF;
  if (size >= 0x7C00) return intBitsToFloat(sign | 0x7F800000 | (size & 0x3FF) << 13);
  if (size < 0x400) return (sign != 0 ? -1.0 : 1.0) * float(size) * 5.9604644775390625e-8;
  return intBitsToFloat(sign | (size << 13) + 0x38000000);
}
float arb_pk2h(vec2 a) { return intBitsToFloat(arb_half(a.x) | arb_half(a.y) << 16); }
vec4 arb_up2h(float x) {
  int bits = floatBitsToInt(x);
  return vec2(arb_single(bits & 0xFFFF), arb_single(bits >> 16 & 0xFFFF)).xyxy;
}
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t4;
  vec4 t5;
  vec4 t6;
  vec4 t7;
  vec4 t8;
  vec4 t9;
  t2.x = float(gl_Color.x < arb_param[0].x);
  t0.xy = -t2.x < 0.0 ? arb_param[1].xy : vec2(0.0);
  t1.xy = clamp(t0.xy * t2.xx + arb_param[2].xy, 0.0, 1.0);
  t2.x = arb_pk2h(t1.xy);
  t2.xy = arb_up2h(t2.x).xy;
  t0.xy = dFdy(gl_TexCoord[0].xy);
  t1.xyz = texture2DGradARB(arb_tex0, gl_TexCoord[0].xy, t0.xy, t2.xy).xyz;
  t4.x = dot(t1.xyz, arb_param[1].xyz);
  t6.x = dot(t1.xyz, t1.xyz);
  t7.x = t4.x + t4.x;
  t8.x = 1.0 / t6.x;
  t9.x = t7.x * t8.x;
  t5.xyz = t9.xxx * t1.xyz + -arb_param[1].xyz;
  t5.w = arb_param[0].w;
  gl_FragColor = t5;
}
