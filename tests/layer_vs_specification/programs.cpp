#include "programs.h"

namespace api {

namespace {

GLuint compile(GLenum type, const char *text) {
  const GLuint shader = glCreateShader(type);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

} // namespace

void load(const std::string &text, GLenum target) {
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
}

GLuint makeProgram(const std::string &text, GLenum target) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  load(text, target);
  return name;
}

GLint programiv(GLenum pname, GLenum target) {
  GLint value = -12345;
  glGetProgramivARB(target, pname, &value);
  return value;
}

GLint integer(GLenum pname) {
  GLint value = -12345;
  glGetIntegerv(pname, &value);
  return value;
}

void clear() {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

void drawQuad() {
  glColor4f(0, 0, 1, 1);
  glBegin(GL_QUADS);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
}

Picture readPicture(int size) {
  Picture picture(std::size_t(4 * size * size));
  glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  return picture;
}
Pixel readPixel(int x, int y) {
  std::array<GLubyte, 4> bytes = {1, 2, 3, 4};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return {bytes[0], bytes[1], bytes[2], bytes[3]};
}

Pixel drawn() {
  clear();
  drawQuad();
  return readPixel();
}

GLuint makeGlsl(const char *vertex, const char *fragment) {
  const GLuint program = glCreateProgram();
  if (vertex)
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
  if (fragment)
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
  glLinkProgram(program);
  return program;
}

} // namespace api
