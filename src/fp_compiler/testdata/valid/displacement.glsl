#version 120
uniform vec4 arb_param[1];
uniform sampler2D arb_tex1;
uniform sampler2D arb_tex0;
void main() {
  vec4 t0;
  vec4 t1;
  t0.xy = texture2D(arb_tex1, gl_TexCoord[0].xy).xy;
  t1.xy = t0.xy * arb_param[0].xy + gl_TexCoord[0].xy;
  gl_FragColor = texture2D(arb_tex0, t1.xy);
}
