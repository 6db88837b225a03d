#version 120
void main() {
  vec4 t1;
  vec4 t2;
  vec4 t3;
  t1 = gl_Vertex + gl_Vertex.xxxx;
  t2 = t1 * vec4(0.5);
  t3 = max(t2, vec4(0.0));
  gl_Position = t3;
  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;
}
