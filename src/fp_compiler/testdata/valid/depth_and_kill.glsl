#version 120
uniform vec4 arb_param[1];
void main() {
  vec4 t0;
  t0.xyz = gl_FragCoord.zzz - arb_param[0].xyz;
  if (any(lessThan(-t0.xy, vec2(0.0)))) discard;
  gl_FragDepth = t0.z * 0.5 + 0.5;
  gl_FragColor = gl_SecondaryColor;
}
