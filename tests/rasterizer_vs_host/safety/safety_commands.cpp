#include "safety.h"

#include <climits>

namespace software {

namespace {

constexpr const char *kColor = "MOV result.color, fragment.color;\n";
constexpr const char *kTexture = "TEX result.color, fragment.texcoord[0], texture[0], 2D;\n";

void copiesOutOfRange() {
  useFragments(kColor);
  wholeQuad();
  smoothTexture(32, 32);
  static constexpr int kRanges[][6] = {
      {-1, 0, 0, 0, 8, 8},        {0, 0, 0, 0, 33, 8},           {30, 30, 0, 0, 8, 8},
      {0, 0, -40, -40, 32, 32},   {0, 0, kSide - 4, 60, 16, 16}, {0, 0, 0, 0, -1, 4},
      {0, 0, 0, 0, 0, 0},         {INT_MAX, 0, 0, 0, 8, 8},      {0, 0, INT_MAX, INT_MAX, 8, 8},
      {0, 0, INT_MIN, 0, 32, 32}, {8, 8, 0, 0, INT_MAX, 8}};
  for (const auto &r : kRanges) {
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, r[0], r[1], r[2], r[3], r[4], r[5]);
    note("CopyTexSubImage2D");
  }
  glCopyTexSubImage2D(GL_TEXTURE_2D, 5, 0, 0, 0, 0, 8, 8);
  note("no such level");
  glCopyTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 0, 0, 8, 8);
  note("a negative level");
  glCopyTexSubImage2D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 8, 8);
  note("another target");
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, -4, 8, 0);
  note("a negative size");
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 1 << 20, 8, 0);
  note("a huge size");
  glCopyTexImage2D(GL_TEXTURE_2D, 0, 0x1234, 0, 0, 8, 8, 0);
  note("no format");
  useFragments(kTexture);
  wholeQuad();
  note("a draw of it");
}

void readsOutOfRange() {
  useFragments(kColor);
  wholeQuad();
  std::vector<unsigned char> bytes(128 * 128 * 16, 7);
  glReadPixels(-20, -20, 100, 100, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  note("around the window");
  glReadPixels(INT_MAX - 4, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  note("far away");
  glReadPixels(0, 0, -1, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  note("a negative size");
  glReadPixels(0, 0, 8, 8, 0x1234, GL_UNSIGNED_BYTE, bytes.data());
  note("no format");
  glReadPixels(0, 0, 8, 8, GL_RGBA, 0x1234, bytes.data());
  note("no type");
  glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
  glPixelStorei(GL_PACK_ROW_LENGTH, 70);
  glReadPixels(0, 0, kSide, kSide, GL_BGRA, GL_UNSIGNED_BYTE, bytes.data());
  record("picture packed", bytes);
  glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  note("a texture without an image");
  glGetTexImage(GL_TEXTURE_2D, 40, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  note("no such level");
}

/// Issues commands at invalid times and with invalid arguments.
void errors() {
  useFragments(kColor);
  glBegin(GL_TRIANGLES);
  glVertex2f(-1, -1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBegin(GL_LINES);
  glEnable(GL_BLEND);
  glClear(GL_COLOR_BUFFER_BIT);
  glFinish();
  glVertex2f(1, -1);
  glVertex2f(0, 1);
  glEnd();
  note("inside Begin");
  glEnd();
  note("End alone");
  glBegin(0x1234);
  note("no mode");
  glDrawArrays(GL_TRIANGLES, 0, -3);
  note("a negative count");
  glDrawArrays(GL_TRIANGLES, -1, 3);
  note("a negative first");
  glDrawArrays(0x1234, 0, 3);
  note("no mode");
  glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr);
  note("no index type");
  glDrawArrays(GL_TRIANGLES, 0, 0);
  note("no vertices");
  glDrawArrays(GL_TRIANGLES, 0, 3);
  note("no array");
  glClear(0x12345678);
  note("no buffer");
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 100000, 0, 0, 0, 0);
  note("no parameter");
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 0);
  wholeQuad();
  note("program 0");
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 4321);
  wholeQuad();
  note("a program without a text");
  glPopAttrib();
  note("an empty stack");
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, 0);
}

void incompleteTargets() {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  useFragments(kColor);
  wholeQuad();
  note("nothing attached");
  glClear(GL_COLOR_BUFFER_BIT);
  note("Clear of nothing");
  std::vector<unsigned char> bytes(kSide * kSide * 4);
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  note("ReadPixels of nothing");
  GLuint empty = 0;
  glGenTextures(1, &empty);
  glBindTexture(GL_TEXTURE_2D, empty);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, empty, 0);
  wholeQuad();
  note("a texture without an image");
  const GLuint texture = smoothTexture(kSide, kSide);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  wholeQuad();
  note("complete");
  glDeleteTextures(1, &texture); // detaches it
  wholeQuad();
  note("deleted");
  glDeleteFramebuffers(1, &framebuffer);
  wholeQuad();
  picture("the window's again");
}

void oddViewports() {
  useFragments(kColor);
  static constexpr int kViewports[][4] = {{0, 0, 0, 0},
                                          {-30000, -30000, 60000, 60000},
                                          {INT_MAX, INT_MAX, 5, 5},
                                          {INT_MIN, INT_MIN, INT_MAX, INT_MAX},
                                          {0, 0, INT_MAX, INT_MAX},
                                          {0, 0, -1, 5},
                                          {1000, 1000, 10, 10}};
  for (const auto &v : kViewports) {
    glViewport(v[0], v[1], v[2], v[3]);
    note("viewport");
    wholeQuad();
    glScissor(v[0], v[1], v[2], v[3]);
    note("scissor");
    glEnable(GL_SCISSOR_TEST);
    wholeQuad();
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    note("drawn");
  }
  for (const double range : {-1e30, 1e30, 0.0}) {
    glDepthRange(range, -range);
    wholeQuad();
  }
  note("depth ranges");
}

/// Deletes objects while they are bound.
void deleted() {
  const GLuint texture = smoothTexture(16, 16);
  const GLuint program =
      makeProgram(GL_FRAGMENT_PROGRAM_ARB, std::string("!!ARBfp1.0\n") + kTexture + "END\n");
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  wholeQuad(0.01f, 0.01f, 1.01f, 1.01f);
  picture("before");
  glDeleteTextures(1, &texture);
  wholeQuad();
  picture("no texture");
  glDeleteProgramsARB(1, &program);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  static constexpr float kCorners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
  glBufferData(GL_ARRAY_BUFFER, sizeof kCorners, kCorners, GL_STATIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  useFragments(kColor);
  glColor4ub(70, 80, 90, 255);
  glDrawArrays(GL_QUADS, 0, 4);
  picture("a buffer");
  glDisableClientState(GL_VERTEX_ARRAY);
  glDeleteBuffers(1, &buffer);
  note("no buffer");
}

} // namespace

const std::vector<Hazard> kCommandHazards = {
    {"copies-out-of-range", copiesOutOfRange},
    {"reads-out-of-range", readsOutOfRange},
    {"errors", errors},
    {"incomplete-targets", incompleteTargets},
    {"odd-viewports", oddViewports},
    {"deleted", deleted},
};

} // namespace software
