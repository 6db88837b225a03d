#version 120
void main() {
  gl_FragColor = vec4(0.0);
  gl_FragColor.xyz = vec3(0.5);
}
