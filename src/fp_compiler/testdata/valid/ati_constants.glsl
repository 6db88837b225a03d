#version 120
uniform vec4 arb_param[2];
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  t1 = clamp(arb_param[0], 0.0, 1.0);
  t2.x = clamp(arb_param[1].x, 0.0, 1.0);
  t0.xyz = t1.xyz * t2.xxx + gl_SecondaryColor.xyz;
  t0.w = t1.w;
  t0 = mix(t0, vec4(0.5, 0.0, 0.0, 1.0), vec4(0.0));
  gl_FragColor = t0;
}
