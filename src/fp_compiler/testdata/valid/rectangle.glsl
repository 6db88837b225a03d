#version 120
#extension GL_ARB_texture_rectangle : enable
uniform sampler2DRect arb_tex0;
void main() {
  vec4 t0;
  vec4 t1;
  t0 = texture2DRect(arb_tex0, gl_TexCoord[0].xy / gl_TexCoord[0].w);
  t1.xyw = gl_TexCoord[0].xyw + vec3(1.0, 0.0, 0.0);
  t1 = texture2DRect(arb_tex0, t1.xy / t1.w);
  gl_FragColor = mix(t1, t0, vec4(0.25, 0.25, 0.25, 1.0));
}
