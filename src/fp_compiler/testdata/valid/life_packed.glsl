#version 120
uniform sampler2D arb_tex0;
uniform sampler2D arb_tex1;
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  t1.xyz = texture2D(arb_tex0, gl_TexCoord[0].xy).xyz;
  t0.xyz = texture2D(arb_tex0, gl_TexCoord[1].xy).xyz;
  t2.xyz = texture2D(arb_tex0, gl_TexCoord[2].xy).xyz;
  t3.xyz = t0.xyz + t2.xyz;
  t3.xyz = t3.xyz + t1.xyz;
  t3.x = dot(t3.xyz, vec3(0.1));
  t3.y = t1.y;
  gl_FragColor = texture2D(arb_tex1, t3.xy);
}
