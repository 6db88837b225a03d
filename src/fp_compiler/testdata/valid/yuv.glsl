#version 120
uniform sampler2D arb_tex0;
uniform sampler2D arb_tex1;
uniform sampler2D arb_tex2;
void main() {
  vec4 t0;
  vec4 t1;
  t0.x = texture2D(arb_tex0, gl_TexCoord[0].xy).x;
  t0.y = texture2D(arb_tex1, gl_TexCoord[1].xy).y;
  t0.z = texture2D(arb_tex2, gl_TexCoord[1].xy).z;
  t0.xyz = t0.xyz - vec3(0.0625, 0.5, 0.5);
  t1.x = dot(t0.xyz, vec3(1.164, 0.0, 1.596));
  t1.y = dot(t0.xyz, vec3(1.164, -0.391, -0.813));
  t1.z = dot(t0.xyz, vec3(1.164, 2.018, 0.0));
  gl_FragColor = clamp(vec4(t1.x, t1.y, t1.z, 1.0), 0.0, 1.0);
}
