#version 120
uniform sampler2D arb_tex0;
void main() {
  vec4 t0;
  t0 = texture2D(arb_tex0, gl_TexCoord[0].xy);
  gl_FragColor = t0 * gl_Color;
}
