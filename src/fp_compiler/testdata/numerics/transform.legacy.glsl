#version 120
uniform vec4 arb_vparam[1];
float arb_mul(float a, float b) { return (a == 0.0 || b == 0.0) ? 0.0 : a * b; }
vec2 arb_mul(vec2 a, vec2 b) { return vec2(arb_mul(a.x, b.x), arb_mul(a.y, b.y)); }
vec3 arb_mul(vec3 a, vec3 b) { return vec3(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z)); }
vec4 arb_mul(vec4 a, vec4 b) { return vec4(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z), arb_mul(a.w, b.w)); }
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  gl_Position.x = arb_sum(arb_mul(gl_ModelViewProjectionMatrixTranspose[0], gl_Vertex));
  gl_Position.y = arb_sum(arb_mul(gl_ModelViewProjectionMatrixTranspose[1], gl_Vertex));
  gl_Position.z = arb_sum(arb_mul(gl_ModelViewProjectionMatrixTranspose[2], gl_Vertex));
  gl_Position.w = arb_sum(arb_mul(gl_ModelViewProjectionMatrixTranspose[3], gl_Vertex));
  gl_FrontColor = arb_mul(gl_Color, arb_vparam[0]);
  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;
}
