#version 120
uniform vec4 arb_param[1];
uniform sampler2D arb_tex0;
float arb_mul(float a, float b) { float p = a * b; return p != p && (a == 0.0 || b == 0.0) ? 0.0 : p; }
vec2 arb_mul(vec2 a, vec2 b) { return vec2(arb_mul(a.x, b.x), arb_mul(a.y, b.y)); }
vec3 arb_mul(vec3 a, vec3 b) { return vec3(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z)); }
vec4 arb_mul(vec4 a, vec4 b) { return vec4(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z), arb_mul(a.w, b.w)); }
float arb_sum(vec3 p) { return (p.z + p.y) + p.x; }
float arb_sum(vec4 p) { return ((p.w + p.z) + p.y) + p.x; }
float arb_sum(vec3 p, float w) { return (p.x + (p.z + w)) + p.y; }
void main() {
  vec4 t0;
  vec4 t1;
  t0 = texture2D(arb_tex0, gl_TexCoord[0].xy);
  t1 = arb_mul(t0, arb_param[0]);
  t0 = arb_mul(t1, gl_TexCoord[0]) + t0;
  t1.x = arb_sum(arb_mul(t0.xyz, arb_param[0].xyz));
  t1.y = arb_sum(arb_mul(t0, arb_param[0]));
  t1.z = arb_sum(arb_mul(t0.xyz, arb_param[0].xyz), arb_param[0].w);
  t0.xyz = arb_mul(arb_param[0].xyz, t1.xyz) + arb_mul((1.0 - arb_param[0].xyz), gl_TexCoord[0].xyz);
  t1.xyz = (arb_mul(t0.yzx, arb_param[0].zxy) - arb_mul(t0.zxy, arb_param[0].yzx));
  t1.w = (arb_param[0].y == 0.0 || 1.0 == 1.0 ? 1.0 : (1.0 > 0.0 ? pow(1.0, arb_param[0].y) : 0.0));
  t0.xyz = vec3(1.0, max(t1.x, 0.0), (t1.x > 0.0 ? (clamp(t1.w, -127.99999, 127.99999) != 0.0 && t1.y > 0.0 ? pow(t1.y, clamp(t1.w, -127.99999, 127.99999)) : float(clamp(t1.w, -127.99999, 127.99999) == 0.0)) : 0.0));
  t0.w = 1.0 / t1.x;
  gl_FragColor = arb_mul(t0, t1);
}
