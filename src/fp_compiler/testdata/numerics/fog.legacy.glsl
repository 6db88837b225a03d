#version 120
float arb_mul(float a, float b) { return (a == 0.0 || b == 0.0) ? 0.0 : a * b; }
vec2 arb_mul(vec2 a, vec2 b) { return vec2(arb_mul(a.x, b.x), arb_mul(a.y, b.y)); }
vec3 arb_mul(vec3 a, vec3 b) { return vec3(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z)); }
vec4 arb_mul(vec4 a, vec4 b) { return vec4(arb_mul(a.x, b.x), arb_mul(a.y, b.y), arb_mul(a.z, b.z), arb_mul(a.w, b.w)); }
float arb_mulz(float z, float x) { return (z == 0.0) ? 0.0 : z * x; }
vec2 arb_mulz(vec2 a, vec2 b) { return vec2(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y)); }
vec3 arb_mulz(vec3 a, vec3 b) { return vec3(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z)); }
vec4 arb_mulz(vec4 a, vec4 b) { return vec4(arb_mulz(a.x, b.x), arb_mulz(a.y, b.y), arb_mulz(a.z, b.z), arb_mulz(a.w, b.w)); }
void main() {
  vec4 s1 = vec4(-gl_Fog.scale, gl_Fog.end * gl_Fog.scale, gl_Fog.density * -1.442695041, gl_Fog.density * 1.201122409);
  vec4 t0;
  vec4 t1;
  t0 = arb_mulz(gl_Color, gl_FrontMaterial.diffuse);
  t1.x = arb_mul(gl_FogFragCoord, s1.w);
  t1.x = arb_mul(t1.x, t1.x);
  t1.x = clamp(exp2(-t1.x), 0.0, 1.0);
  t0 = clamp(t0, 0.0, 1.0);
  t0.xyz = t1.xxx * t0.xyz + arb_mulz((1.0 - t1.xxx), gl_Fog.color.xyz);
  gl_FragColor = t0;
}
