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
  gl_FragColor = arb_mulz(gl_Color, gl_FrontMaterial.diffuse);
  float arb_fog = clamp(exp2(arb_mul(gl_Fog.density, gl_FogFragCoord) * arb_mul(gl_Fog.density, gl_FogFragCoord) * -1.442695041), 0.0, 1.0);
  gl_FragColor = clamp(gl_FragColor, 0.0, 1.0);
  gl_FragColor.rgb = mix(gl_Fog.color.rgb, gl_FragColor.rgb, arb_fog);
}
