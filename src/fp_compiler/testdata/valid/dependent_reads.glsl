#version 120
uniform sampler2D arb_tex0;
uniform sampler2D arb_tex1;
uniform sampler2D arb_tex2;
void main() {
  vec4 t0;
  vec4 t1;
  t0.xy = texture2D(arb_tex0, gl_TexCoord[0].xy).xy;
  t1.xy = texture2D(arb_tex1, t0.xy).xy;
  t1.xy = t1.xy * t0.xy;
  t0 = texture2D(arb_tex2, t1.xy);
  gl_FragColor = t0;
}
