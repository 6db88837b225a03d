#version 120
#extension GL_ARB_shader_texture_lod : require
uniform samplerCube arb_tex1;
int arb_times(float x) { return x >= 1.0 ? int(min(x, 65000.0)) : 0; }
void main() {
  vec4 t0 = vec4(0.0);
  vec4 t1 = vec4(0.0);
  vec4 t2 = vec4(0.0);
  vec4 t3 = vec4(0.0);
  vec4 t4 = vec4(0.0);
  vec4 t5 = vec4(0.0);
  vec4 t6 = vec4(0.0);
  vec4 t7 = vec4(0.0);
  vec4 t8 = vec4(0.0);
  vec4 t9 = vec4(0.0);
  vec4 t10 = vec4(0.0);
  vec4 t11 = vec4(0.0);
  vec4 t12 = vec4(0.0);
  vec4 t13 = vec4(0.0);
  vec4 t14 = vec4(0.0);
  int arb_left = 65000;
  t0 = vec4(0.0);
  t3.x = floor(0.0);
  t4.x = floor(1.0);
  int arb_n0 = arb_times(3.0);
  for (int arb_i0 = 0; arb_i0 < arb_n0 && arb_left > 0; ++arb_i0) {
  --arb_left;
  t5.x = max(t3.x, 0.0);
  t6.x = t5.x + 0.0;
  t7 = vec4(0.0);
  t8.x = float(t6.x == 0.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[0] : t7;
  t8.x = float(t6.x == 1.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[1] : t7;
  t8.x = float(t6.x == 2.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[2] : t7;
  t8.x = float(t6.x == 3.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[3] : t7;
  t8.x = float(t6.x == 4.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[4] : t7;
  t8.x = float(t6.x == 5.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[5] : t7;
  t8.x = float(t6.x == 6.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[6] : t7;
  t8.x = float(t6.x == 7.0);
  t7 = -t8.x < 0.0 ? gl_TexCoord[7] : t7;
  t0 = t0 + t7;
  t2.x = float(4.0 < t0.x);
  t9.x = t2.x;
  t5 = vec4(not(equal(t9.xxxx, vec4(0.0))));
  t10.x = t5.x;
  t6.x = t10.x * 1.0;
  if (t6.x != 0.0) break;
  t3.x = t3.x + t4.x;
  }
  t0 = t0 * vec4(0.5);
  t0 = t0 * vec4(0.5);
  t2.x = float((gl_FrontFacing ? 1.0 : -1.0) >= 0.0);
  t9.x = t2.x;
  t5 = vec4(not(equal(t9.xxxx, vec4(0.0))));
  t11.x = t5.x;
  t12.x = t11.x;
  t6.x = dot(vec3(t0.x, t0.y, 0.0), vec3(t0.x, t0.y, 0.0));
  t5 = t6.xxxx + t0.xxxx;
  t1 = -t12.x < 0.0 ? t5 : t1;
  t5.x = 1.0 - t11.x;
  t13.x = t5.x;
  t6.x = 1.0 / 3.0;
  t5 = t0 * t6.xxxx;
  t1 = -t13.x < 0.0 ? t5 : t1;
  t6.x = dot(t1.xyz, t1.xyz);
  t7.x = inversesqrt(abs(t6.x));
  t5.xyz = t1.xyz * t7.xxx;
  t1.xyz = -t13.x < 0.0 ? t5.xyz : t1.xyz;
  t0 = textureCubeLod(arb_tex1, t1.xyz, t1.w);
  t14 = t0 * t1;
  gl_FragColor = t14;
}
