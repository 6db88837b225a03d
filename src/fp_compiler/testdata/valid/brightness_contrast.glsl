#version 120
uniform vec4 arb_param[1];
uniform sampler2D arb_tex0;
void main() {
  vec4 t0;
  vec4 t1;
  t0 = texture2D(arb_tex0, gl_TexCoord[0].xy);
  t1.xyz = t0.xyz - vec3(0.5);
  t1.xyz = t1.xyz * arb_param[0].yyy + vec3(0.5);
  t1.xyz = clamp(t1.xyz + arb_param[0].xxx, 0.0, 1.0);
  t0.x = (arb_param[0].z != 0.0 && t1.x > 0.0 ? pow(t1.x, arb_param[0].z) : float(arb_param[0].z == 0.0));
  t0.y = (arb_param[0].z != 0.0 && t1.y > 0.0 ? pow(t1.y, arb_param[0].z) : float(arb_param[0].z == 0.0));
  t0.z = (arb_param[0].z != 0.0 && t1.z > 0.0 ? pow(t1.z, arb_param[0].z) : float(arb_param[0].z == 0.0));
  gl_FragColor = t0;
}
