#version 120
uniform sampler2D arb_tex4;
uniform sampler2D arb_tex0;
void main() {
  vec4 t4;
  vec4 t5;
  vec4 t6;
  vec4 t7;
  vec4 t12;
  vec4 t13;
  t4.xyz = texture2D(arb_tex4, gl_TexCoord[5].xy).xyz;
  t6.xyz = t4.xyz - vec3(0.5);
  t7.xyz = t6.xyz * vec3(2.0);
  t5.x = dot(gl_TexCoord[0].xyz, t7.xyz);
  t5.y = dot(gl_TexCoord[1].xyz, t7.xyz);
  t5.z = dot(gl_TexCoord[2].xyz, t7.xyz);
  t12.xy = vec2(dot(t5.xyz, gl_TexCoord[3].xyz));
  t4.xy = t12.xy * vec2(2.0);
  t5.xy = t4.xy * t5.xy + -gl_TexCoord[3].xy;
  t13 = texture2D(arb_tex0, t5.xy);
  gl_FragColor = t13;
}
