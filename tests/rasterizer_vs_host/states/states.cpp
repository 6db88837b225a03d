// Draws a scene for each line of its input, each in a context of its own, and writes the resulting
// colors, depths, stencil values and GL errors as records, which run_states.py compares.
#include "states.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>

namespace software {

Scene::Scene(const std::string &line) {
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    m_values[word.substr(0, equals)] = std::strtod(word.c_str() + equals + 1, nullptr);
  }
}

double Scene::number(const std::string &name) const {
  const auto found = m_values.find(name);
  if (found != m_values.end())
    return found->second;
  std::fprintf(stderr, "rasterizer-states: the scene has no '%s'\n", name.c_str());
  std::exit(2);
}

namespace {

/// Attaches the bound framebuffer's color buffer: a 2D texture, a slice of a 3D one, a face of a
/// cube map, or a renderbuffer.
void attachColor(const Scene &scene) {
  const GLint internal = scene.choice("target");
  GLuint name = 0;
  if (scene.choice("attachment") == 3) {
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorage(GL_RENDERBUFFER, GLenum(internal), kEdge, kEdge);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
    return;
  }
  constexpr GLenum kTargets[] = {GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
  const GLenum target = kTargets[scene.choice("attachment")];
  glGenTextures(1, &name);
  glBindTexture(target, name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  if (target == GL_TEXTURE_3D) {
    glTexImage3D(target, 0, internal, kEdge, kEdge, 5, 0, GL_RGBA, GL_FLOAT, nullptr);
    glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, name, 0, 3);
  } else {
    const bool cube = target == GL_TEXTURE_CUBE_MAP;
    for (GLenum face = 0; face < (cube ? 6 : 1); ++face)
      glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : target, 0, internal, kEdge, kEdge,
                   0, GL_RGBA, GL_FLOAT, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                           cube ? GL_TEXTURE_CUBE_MAP_NEGATIVE_Y : target, name, 0);
  }
  glBindTexture(target, 0);
}

void makeTarget(const Scene &scene) {
  if (scene.choice("target") == 0)
    return;
  makeFramebuffer();
  attachColor(scene);
  attachBuffer(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, kEdge, kEdge);
}

/// Clears a part of the drawing, and reads everything, with sRGB encoding.
void clearEncoded() {
  glEnable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, kEdge / 2, kEdge / 3);
  glClearColor(0.2f, 0.4f, 0.6f, 0.3f);
  glClear(GL_COLOR_BUFFER_BIT);
}

void draw(const Scene &scene) {
  glDisable(GL_DITHER);
  makeTarget(scene);
  glViewport(0, 0, kEdge, kEdge);
  drawBackground();
  makeSceneTexture(scene);
  setProgramState(scene);
  setRasterState(scene);
  const GLenum test = scene.token("depth_test");
  if (test == GL_EQUAL || test == GL_LEQUAL || test == GL_GEQUAL || test == GL_NOTEQUAL) {
    // The same primitives give depths that are equal to the last bit.
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    drawPrimitives(scene, 0);
  }
  setPixelState(scene);
  drawPrimitives(scene, test == GL_EQUAL || test == GL_NOTEQUAL ? 0 : 1);
  if (scene.choice("encode") == 2)
    clearEncoded();
}

void writeAll(const std::string &name) {
  record(name + " color", readRgba(0, 0, kEdge, kEdge));
  std::vector<unsigned char> bytes(std::size_t(kEdge) * kEdge * 16);
  glReadPixels(0, 0, kEdge, kEdge, GL_RGBA, GL_FLOAT, bytes.data());
  record(name + " float", bytes);
  bytes.resize(std::size_t(kEdge) * kEdge * 4);
  glReadPixels(0, 0, kEdge, kEdge, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, bytes.data());
  record(name + " depth", bytes);
  bytes.resize(std::size_t(kEdge) * kEdge);
  glReadPixels(0, 0, kEdge, kEdge, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes.data());
  record(name + " stencil", bytes);
  record(name + " errors" + takeErrors(), {});
  std::fflush(stdout);
}

} // namespace
} // namespace software

int main() {
  using namespace software;
  software::Screen screen;
  if (!screen.open())
    return 1;
  const GLXDrawable window = screen.makeWindow(kEdge, kEdge);
  int number = 0;
  for (std::string line; std::getline(std::cin, line); ++number) {
    const GLXContext context = screen.makeContext();
    screen.makeCurrent(window, context);
    draw(Scene(line));
    writeAll(std::to_string(number));
    screen.destroy(context);
  }
  return 0;
}
