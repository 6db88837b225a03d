#version 120
#extension GL_EXT_gpu_shader4 : require
#extension GL_ARB_shader_bit_encoding : require
float arb_nearest(float x) {
  float low = floor(x), over = x - low;
  return over > 0.5 || over == 0.5 && (int(low) & 1) == 1 ? low + 1.0 : low;
}
int arb_unsigned(float x, float most) {
  return int(arb_nearest((x > 0.0 ? min(x, 1.0) : 0.0) * most));
}
vec4 arb_bytes(float x) {
  int bits = floatBitsToInt(x);
  return vec4(float(bits & 255), float(bits >> 8 & 255), float(bits >> 16 & 255), float(bits >> 24 & 255));
}
float arb_pk4ub(vec4 a) {
  return intBitsToFloat(arb_unsigned(a.x, 255.0) | arb_unsigned(a.y, 255.0) << 8 | arb_unsigned(a.z, 255.0) << 16 | arb_unsigned(a.w, 255.0) << 24);
}
vec4 arb_up4ub(float x) { return arb_bytes(x) / 255.0; }
void main() {
  vec4 t1;
  vec4 t2;
  vec4 t3;
  vec4 t4;
  vec4 t5;
  vec4 t8;
  vec4 t9;
  t1 = gl_Color.x < 0.0 ? -gl_Color : vec4(0.0);
  t8.xy = vec2(greaterThanEqual(gl_Color.yx, vec2(0.0)));
  t9.xy = t1.xy + gl_TexCoord[1].xy;
  t1.xy = vec2(-t8.x < 0.0 ? t9.x : t1.x, -t8.y < 0.0 ? t9.y : t1.y);
  t8 = abs(t1);
  t2 = vec4(lessThan(vec4(0.5, 0.0, 0.0, 1.0), t8));
  t8 = vec4(not(equal(gl_Color.wwww, vec4(0.0))));
  if (any(lessThan(-t8, vec4(0.0)))) discard;
  t3.x = arb_pk4ub(t1);
  t4 = arb_up4ub(t3.x);
  t5 = mix(t1, t4, t2);
  gl_FragColor = t5;
  gl_FragDepth = gl_FragCoord.z;
}
