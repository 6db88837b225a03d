#version 120
uniform vec4 arb_param[1];
void main() {
  vec4 t1;
  vec4 t4;
  t4.xz = -gl_TexCoord[0].xz + arb_param[0].xz;
  t1.y = abs(t4.x);
  gl_FragColor.xyz = vec3(t4.x, 1.0, -t4.z);
  gl_FragColor.w = t1.y;
}
