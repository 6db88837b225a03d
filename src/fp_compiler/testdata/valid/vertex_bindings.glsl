#version 120
attribute vec4 arb_attrib1;
attribute vec4 arb_attrib6;
float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }
float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }
float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }
void main() {
  vec4 s6 = vec4(gl_Point.size, gl_Point.sizeMin, gl_Point.sizeMax, gl_Point.fadeThresholdSize);
  vec4 s7 = vec4(gl_Point.distanceConstantAttenuation, gl_Point.distanceLinearAttenuation, gl_Point.distanceQuadraticAttenuation, 1.0);
  vec4 t0;
  gl_FrontSecondaryColor = vec4(0.0);
  gl_TexCoord[7] = vec4(0.0);
  t0 = gl_Vertex + vec4(gl_Normal.x, gl_Normal.y, gl_Normal.z, 1.0);
  t0 = gl_Color * gl_SecondaryColor + t0;
  t0 = vec4(gl_FogCoord) * gl_MultiTexCoord7 + t0;
  t0 = t0 + arb_attrib1;
  t0 = arb_attrib6 * gl_EyePlaneS[0] + t0;
  t0.x = arb_sum(t0 * gl_ClipPlane[5]);
  gl_Position = t0;
  gl_FrontColor = gl_EyePlaneT[0];
  gl_FrontSecondaryColor.xyz = gl_ObjectPlaneR[3].xyz;
  gl_BackColor = gl_ObjectPlaneQ[7];
  gl_BackSecondaryColor = gl_ClipPlane[0];
  gl_FogFragCoord = t0.x;
  gl_PointSize = s6.x * s7.y;
  gl_TexCoord[0] = gl_MultiTexCoord0;
  gl_TexCoord[7].xy = t0.xy;
  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;
}
