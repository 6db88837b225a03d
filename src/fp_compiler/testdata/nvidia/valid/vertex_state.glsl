#version 120
void main() {
  vec4 t0;
  vec4 t2;
  vec4 t5;
  gl_Position = ftransform();
  t0 = clamp(gl_Color + gl_Fog.color, 0.0, 1.0);
  t5 = vec4(equal(t0.xxxx, vec4(0.0)));
  t2 = vec4(-t5.x < 0.0 ? 1.0 : 0.0, -t5.y < 0.0 ? 1.0 : 0.0, -t5.z < 0.0 ? 1.0 : 0.0, -t5.w < 0.0 ? 1.0 : 1.0);
  gl_FrontColor = t0;
  gl_BackColor = t2;
  gl_PointSize = t0.x;
  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
}
