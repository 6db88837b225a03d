#version 120
uniform vec4 arb_param[2];
void main() {
  vec4 t0;
  vec4 t1;
  t0.xz = clamp(gl_TexCoord[0].xz, 0.0, 1.0);
  t1.x = pow(t0.x, 2.5);
  t1.y = pow(max(gl_TexCoord[0].y, 0.0), 2.5);
  t1.z = (arb_param[0].x != 0.0 && t0.z > 0.0 ? pow(t0.z, arb_param[0].x) : float(arb_param[0].x == 0.0));
  t0.w = max(gl_TexCoord[1].w, 0.0);
  t1.w = (gl_TexCoord[1].x != 0.0 && t0.w > 0.0 ? pow(t0.w, gl_TexCoord[1].x) : float(gl_TexCoord[1].x == 0.0));
  t0 = vec4(1.0, max(t1.x, 0.0), (t1.x > 0.0 ? (clamp(t1.w, -127.99999, 127.99999) != 0.0 && t1.y > 0.0 ? pow(t1.y, clamp(t1.w, -127.99999, 127.99999)) : float(clamp(t1.w, -127.99999, 127.99999) == 0.0)) : 0.0), 1.0);
  t1.yzw = vec3(greaterThanEqual(t0.yzw, t1.yzw));
  t1.y = t1.y * t0.y;
  t0.w = arb_param[1].x;
  t0.z = (t0.x > 0.0 ? (clamp(t0.w, -127.99999, 127.99999) != 0.0 && t0.y > 0.0 ? pow(t0.y, clamp(t0.w, -127.99999, 127.99999)) : float(clamp(t0.w, -127.99999, 127.99999) == 0.0)) : 0.0);
  t1.xw = vec2(1.0, t1.w);
  t0.xy = vec2(cos(t0.x), sin(t0.x));
  t1.xyz = cross(t0.xyz, t1.xyz);
  gl_FragColor = t0 + t1;
}
