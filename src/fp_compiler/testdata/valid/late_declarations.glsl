#version 120
uniform vec4 arb_param[1];
void main() {
  vec4 t1;
  t1 = gl_Color * arb_param[0];
  gl_FragColor = t1;
}
