#version 120
uniform sampler2D arb_tex0;
void main() {
  gl_FragColor = texture2D(arb_tex0, gl_TexCoord[0].xy);
}
