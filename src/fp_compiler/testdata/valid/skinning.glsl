#version 120
uniform vec4 arb_vparam[24];
attribute vec4 arb_attrib7;
attribute vec4 arb_attrib1;
vec4 arb_array0(int i) { return i >= 0 && i < 24 ? arb_vparam[i] : vec4(0.0); }
int arb_address(float x) { return abs(x) < 1073741824.0 ? int(floor(x)) : -1073741824; }
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  int a0 = 0;
  gl_Position = ftransform();
  t2.xy = arb_attrib7.xy * vec2(3.0);
  a0 = arb_address(t2.x);
  t3.xyz = arb_array0(a0).xyz;
  t0.x = arb_sum(t3.xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t3.xyz = arb_array0(a0 + 1).xyz;
  t0.y = arb_sum(t3.xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t3.xyz = arb_array0(a0 + 2).xyz;
  t0.z = arb_sum(t3.xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t1.xyz = t0.xyz * arb_attrib1.xxx;
  a0 = arb_address(t2.y);
  t3.xyz = arb_array0(a0).xyz;
  t0.x = arb_sum(t3.xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t3.xyz = arb_array0(a0 + 1).xyz;
  t0.y = arb_sum(t3.xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t3.xyz = arb_array0(a0 + 2).xyz;
  t0.z = arb_sum(t3.xyz * vec3(gl_Normal.x, gl_Normal.y, gl_Normal.z));
  t1.xyz = t0.xyz * arb_attrib1.yyy + t1.xyz;
  t1.w = arb_sum(t1.xyz * t1.xyz);
  t1.w = inversesqrt(abs(t1.w));
  t1.xyz = t1.xyz * t1.www;
  gl_FrontColor = vec4(arb_sum(t1.xyz * vec3(0.3, 0.5, 0.8)));
  gl_TexCoord[0] = gl_MultiTexCoord0;
  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
}
