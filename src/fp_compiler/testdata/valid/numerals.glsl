#version 120
void main() {
  gl_FragColor = vec4(0.0, -3.0, -2000.0, 3.4028235e+38);
}
