#version 120
uniform sampler2D arb_tex0;
void main() {
  vec4 t0;
  t0 = texture2DProj(arb_tex0, gl_TexCoord[0].xyw);
  t0 = t0 * gl_Color;
  gl_FragColor = t0;
}
