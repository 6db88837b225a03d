#version 120
uniform sampler2D arb_tex1;
uniform sampler2D arb_tex0;
void main() {
  vec4 s5 = vec4(gl_FrontMaterial.shininess, 0.0, 0.0, 1.0);
  vec4 s1 = vec4(gl_LightSource[0].diffuse.rgb * gl_FrontMaterial.diffuse.rgb, gl_FrontMaterial.diffuse.a);
  vec4 s2 = vec4(gl_LightSource[0].specular.rgb * gl_FrontMaterial.specular.rgb, gl_FrontMaterial.specular.a);
  vec4 t0;
  vec4 t1;
  vec4 t2;
  vec4 t3;
  vec4 t4;
  t0.xyz = texture2D(arb_tex1, gl_TexCoord[0].xy).xyz;
  t0.xyz = t0.xyz * vec3(2.0) + vec3(-1.0);
  t1.w = dot(gl_TexCoord[1].xyz, gl_TexCoord[1].xyz);
  t1.w = inversesqrt(abs(t1.w));
  t1.xyz = t1.www * gl_TexCoord[1].xyz;
  t2.w = dot(gl_TexCoord[2].xyz, gl_TexCoord[2].xyz);
  t2.w = inversesqrt(abs(t2.w));
  t2.xyz = t2.www * gl_TexCoord[2].xyz + t1.xyz;
  t2.w = dot(t2.xyz, t2.xyz);
  t2.w = inversesqrt(abs(t2.w));
  t2.xyz = t2.xyz * t2.www;
  t3.x = dot(t0.xyz, t1.xyz);
  t3.y = dot(t0.xyz, t2.xyz);
  t3.w = s5.x;
  t3.yz = vec2(max(t3.x, 0.0), (t3.x > 0.0 ? (clamp(t3.w, -127.99999, 127.99999) != 0.0 && t3.y > 0.0 ? pow(t3.y, clamp(t3.w, -127.99999, 127.99999)) : float(clamp(t3.w, -127.99999, 127.99999) == 0.0)) : 0.0));
  t4 = texture2D(arb_tex0, gl_TexCoord[0].xy);
  t1.xyz = t3.yyy * s1.xyz + gl_LightModel.ambient.xyz;
  t1.xyz = t1.xyz * t4.xyz;
  gl_FragColor.xyz = t3.zzz * s2.xyz + t1.xyz;
  gl_FragColor.w = t4.w;
}
