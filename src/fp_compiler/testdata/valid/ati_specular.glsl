#version 120
uniform sampler2D arb_tex1;
uniform sampler2D arb_tex4;
uniform sampler2D arb_tex5;
uniform sampler2D arb_tex0;
uniform sampler2D arb_tex3;
void main() {
  vec4 t0;
  vec4 t2;
  vec4 t3;
  vec4 t4;
  vec4 t5;
  vec4 t6;
  vec4 t7;
  vec4 t10;
  vec4 t11;
  vec4 t12;
  t0.xyz = texture2D(arb_tex1, gl_TexCoord[0].xy).xyz;
  t2.xyz = texture2D(arb_tex4, gl_TexCoord[4].xy).xyz;
  t3.x = texture2D(arb_tex5, gl_TexCoord[0].xy).x;
  t4.xyz = t0.xyz - vec3(0.5);
  t5.xyz = t4.xyz * vec3(2.0);
  t6.xyz = t2.xyz - vec3(0.5);
  t7.xyz = t6.xyz * vec3(2.0);
  t2.xyz = vec3(dot(t5.xyz, t7.xyz));
  t0.x = dot(t5.xyz, gl_TexCoord[3].xyz);
  t0.x = t0.x * t0.x;
  t0.z = dot(gl_TexCoord[3].xyz, gl_TexCoord[3].xyz);
  t10.y = t0.z * t3.x;
  t0.y = t10.y * 0.5;
  t11.xyz = texture2D(arb_tex0, gl_TexCoord[0].xy).xyz;
  t12.xyz = texture2DProj(arb_tex3, t0.xyz).xyz;
  t12.xyz = t12.xyz * t2.xyz;
  t11.xyz = clamp(t11.xyz * t2.xyz + t12.xyz, 0.0, 1.0);
  gl_FragColor = vec4(t11.x, t11.y, t11.z, 1.0);
}
