#version 120
float arb_mulz(float z, float x) { return (z == 0.0) ? 0.0 : z * x; }
vec2 arb_mulz(vec2 a, vec2 b) { return vec2(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y)); }
vec3 arb_mulz(vec3 a, vec3 b) { return vec3(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z)); }
vec4 arb_mulz(vec4 a, vec4 b) { return vec4(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z), arb_mulz(a.w, b.w)); }
void main() {
  vec4 t0;
  vec4 t1;
  t0.xyz = gl_Color.xyz * vec3(0.0, 1.0, 0.5);
  t1.xyz = clamp(gl_TexCoord[1].xyz * vec3(2.0) + t0.xyz, 0.0, 1.0);
  t0.xyz = mix(gl_SecondaryColor.xyz, gl_Color.xyz, t1.xyz);
  t0.w = dot(t0.xyz, t1.xyz);
  t1.xyz = arb_mulz(t0.xyz, gl_TexCoord[2].xyz);
  t1.w = arb_mulz(t0.w, gl_TexCoord[2].w);
  gl_FragColor = t1 * vec4(0.25) + t0;
}
