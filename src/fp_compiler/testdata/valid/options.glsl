#version 120
#extension GL_ARB_fragment_coord_conventions : enable
layout(origin_upper_left, pixel_center_integer) varying vec4 gl_FragCoord;
uniform sampler2DShadow arb_tex0;
void main() {
  vec4 s0 = vec4(-gl_Fog.scale, gl_Fog.end * gl_Fog.scale, gl_Fog.density * -1.442695041, gl_Fog.density * 1.201122409);
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  t0.x = shadow2DProj(arb_tex0, gl_TexCoord[0]).x;
  t1 = t0.xxxx * gl_Color;
  t3.x = gl_FogFragCoord * s0.w;
  t3.x = t3.x * t3.x;
  t3.x = clamp(exp2(-t3.x), 0.0, 1.0);
  t1 = clamp(t1, 0.0, 1.0);
  t1.xyz = mix(gl_Fog.color.xyz, t1.xyz, t3.xxx);
  t2 = clamp(gl_FragCoord, 0.0, 1.0);
  t2.xyz = mix(gl_Fog.color.xyz, t2.xyz, t3.xxx);
  gl_FragData[0] = t1;
  gl_FragData[1] = t2;
}
