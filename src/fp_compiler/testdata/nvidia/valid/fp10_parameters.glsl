#version 120
uniform vec4 arb_param[3];
uniform sampler2D arb_tex0;
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  t0.xyz = texture2D(arb_tex0, gl_TexCoord[0].xy).xyz;
  t1.xyz = t0.xyz * arb_param[0].xyz;
  t1.xyz = t1.xyz + arb_param[1].xyz;
  t2.xyz = clamp(t1.xyz + arb_param[2].xyz, 0.0, 1.0);
  t3 = vec4(t2.x, t2.y, t2.z, 0.0) * vec4(0.5);
  gl_FragColor = t3;
}
