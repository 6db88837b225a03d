#version 120
#extension GL_ARB_shader_texture_lod : enable
attribute vec4 arb_attrib1;
uniform sampler2D arb_tex0;
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t13;
  t0 = texture2DLod(arb_tex0, gl_MultiTexCoord0.xy, gl_MultiTexCoord0.w);
  t1 = t0 * vec4(2.0) + vec4(-1.0);
  t13 = vec4(gl_Normal.x, gl_Normal.y, gl_Normal.z, 1.0) * t0.xxxx + gl_Vertex;
  t1 = t1.x < 0.0 ? t13 : t1;
  gl_TexCoord[0] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_TexCoord[1] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_TexCoord[2] = t0;
  gl_TexCoord[3] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_TexCoord[4] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_TexCoord[5] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_TexCoord[6] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_TexCoord[7] = vec4(0.0, 0.0, 0.0, 1.0);
  gl_Position = t1;
  gl_FrontColor = arb_attrib1;
}
