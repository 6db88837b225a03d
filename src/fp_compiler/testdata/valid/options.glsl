#version 120
#extension GL_ARB_fragment_coord_conventions : enable
layout(origin_upper_left, pixel_center_integer) varying vec4 gl_FragCoord;
uniform sampler2DShadow arb_tex0;
void main() {
  vec4 t0;
  t0.x = shadow2DProj(arb_tex0, gl_TexCoord[0]).x;
  gl_FragData[0] = t0.xxxx * gl_Color;
  gl_FragData[1] = gl_FragCoord;
  float arb_fog = clamp(exp2(gl_Fog.density * gl_FogFragCoord * gl_Fog.density * gl_FogFragCoord * -1.442695041), 0.0, 1.0);
  gl_FragData[0] = clamp(gl_FragData[0], 0.0, 1.0);
  gl_FragData[0].rgb = mix(gl_Fog.color.rgb, gl_FragData[0].rgb, arb_fog);
  gl_FragData[1] = clamp(gl_FragData[1], 0.0, 1.0);
  gl_FragData[1].rgb = mix(gl_Fog.color.rgb, gl_FragData[1].rgb, arb_fog);
}
