#version 120
uniform samplerCube arb_tex2;
void main() {
  vec4 t0;
  vec4 t1;
  t0.yzw = abs(gl_TexCoord[0].yzw);
  t0.yzw = t0.yzw + vec3(0.0);
  t0.yzw = vec3(t0.y < 0.0 ? 0.0 : t0.y, t0.z < 0.0 ? 0.0 : t0.z, t0.w < 0.0 ? 0.0 : t0.w);
  t0.x = cos(t0.y);
  t0.y = dot(t0.xyz, vec3(0.0));
  t0.z = dot(t0, vec4(0.0));
  t1 = vec4(1.0, t0.y * 0.0, t0.z, 0.0);
  t0.xy = floor(t1.xy);
  t0.zw = fract(t1.zw);
  t1.xzw = vec3(1.0, (t0.x > 0.0 ? (clamp(t0.w, -127.99999, 127.99999) != 0.0 && t0.y > 0.0 ? pow(t0.y, clamp(t0.w, -127.99999, 127.99999)) : float(clamp(t0.w, -127.99999, 127.99999) == 0.0)) : 0.0), 1.0);
  t1.xzw = mix(t0.xzw, t1.xzw, t0.xzw);
  t1.xzw = t0.xzw * t1.xzw + t0.xzw;
  t0.w = max(t1.w, t0.w);
  t0.w = min(t1.w, t0.w);
  t0.w = t1.w * t0.w;
  t0.z = inversesqrt(abs(t1.z));
  t0.xy = vec2(cos(t1.x), sin(t1.x));
  t1.w = t0.w;
  t1.xyz = cross(t0.xyz, vec3(-t0.x, 0.0, -1.0));
  if (any(lessThan(t1, vec4(0.0)))) discard;
  t1 = textureCube(arb_tex2, gl_TexCoord[2].xyz, gl_TexCoord[2].w);
  gl_FragColor = clamp(t1, 0.0, 1.0);
}
