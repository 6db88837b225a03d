#version 120
uniform vec4 arb_param[1];
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
  vec4 t15 = vec4(0.0);
  int arb_left = 65000;
  t0 = gl_Color;
  int arb_n0 = arb_times(arb_param[0].x);
  for (int arb_i0 = 0; arb_i0 < arb_n0 && arb_left > 0; ++arb_i0) {
  --arb_left;
  t1 = t0 * gl_TexCoord[0] + vec4(-0.5);
  t3 = t1;
  t4 = vec4(lessThan(vec4(0.0), t3.wwww));
  t5.x = t4.x;
  t6.x = t5.x * 1.0;
  if (t6.x != 0.0) break;
  t4 = vec4(lessThan(t3.xxxx, vec4(0.0)));
  t7.x = t4.x;
  t8 = t0;
  t8.xy = t0.xy + t1.xy;
  t9 = t3;
  t9.xy = t8.xy;
  t4 = vec4(greaterThanEqual(t9.yyyy, vec4(0.0)));
  t10.x = t4.x;
  t11 = t2;
  t11.z = t8.x;
  t12 = t2;
  t12.z = -t10.x < 0.0 ? t11.z : t2.z;
  t4 = -t7.x < 0.0 ? t9.yyyy : vec4(0.0);
  if (any(lessThan(t4, vec4(0.0)))) discard;
  t13 = t0;
  t13 = clamp(t0 * t1, 0.0, 1.0);
  t14 = t2;
  t14 = vec4(0.25);
  t0.xy = -t7.x < 0.0 ? t8.xy : t13.xy;
  t0.zw = -t7.x < 0.0 ? t0.zw : t13.zw;
  t2.z = -t7.x < 0.0 ? t12.z : t14.z;
  t2.xyw = -t7.x < 0.0 ? t2.xyw : t14.xyw;
  t3.xy = -t7.x < 0.0 ? t9.xy : t3.xy;
  }
  t15 = t0 * vec4(0.5) + t2;
  gl_FragColor = t15;
}
