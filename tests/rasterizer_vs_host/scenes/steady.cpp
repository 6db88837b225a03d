// Draws frames whose depths must meet, with a draw in the middle that the rasterizer may lack:
// rasterizer-steady KIND FRAMES. With `whole` the rasterizer supports everything. With `formats` a
// draw samples a signed format, which is known from state. With `indices` a draw restarts a
// primitive, which only its arrays tell. Records the last pictures.
#include <array>
#include <chrono>
#include <cstdlib>
#include <thread>
#include <vector>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 128, kShapes = 6, kFirst = 5, kPictures = 3;

enum class Kind { Whole, Formats, Indices };
struct Name {
  const char *name;
  Kind kind;
};
constexpr Name kNames[] = {
    {"whole", Kind::Whole}, {"formats", Kind::Formats}, {"indices", Kind::Indices}};

/// Two triangles, so that a restart begins a second one.
struct Shape {
  std::array<float, 6 * 3> corners;
};

class Scene {
public:
  explicit Scene(Kind kind) : m_kind(kind) {
    const unsigned char texels[] = {40, 90, 200, 255, 250, 10, 60, 255,
                                    0,  30, 90,  255, 70,  70, 7,  255};
    glGenTextures(2, m_textures);
    for (const GLuint texture : m_textures) {
      glBindTexture(GL_TEXTURE_2D, texture);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      const GLint format = texture == m_textures[0] ? GL_RGBA8 : GL_RGBA8_SNORM;
      glTexImage2D(GL_TEXTURE_2D, 0, format, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
      glTexImage2D(GL_TEXTURE_2D, 1, format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
    (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\nTEMP t;\n"
                                               "TEX t, {0.25}, texture[0], 2D;\n"
                                               "MUL result.color, t, fragment.color;\nEND\n");
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    Random random(11);
    for (Shape &shape : m_shapes)
      for (float &corner : shape.corners)
        corner = float(random.between(-90, 90)) / 100;
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnable(GL_DEPTH_TEST);
    glPrimitiveRestartIndex(0xFFFF);
    glViewport(0, 0, kEdge, kEdge);
  }

  void frame() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    pass();
    // Each shape is drawn again where its depths are met, which only happens if one rasterizer made
    // both.
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    pass();
    glFinish();
  }

private:
  void pass() {
    for (int i = 0; i < kShapes; ++i) {
      const bool odd = i == kShapes / 2;
      glBindTexture(GL_TEXTURE_2D, m_textures[odd && m_kind == Kind::Formats]);
      glColor4f(float(i + 1) / kShapes, 0.5F, 1 - float(i) / kShapes, 1);
      glVertexPointer(3, GL_FLOAT, 0, m_shapes[i].corners.data());
      constexpr GLushort kIndices[] = {0, 1, 2, 0xFFFF, 3, 4, 5}, kPlain[] = {0, 1, 2, 3, 4, 5};
      if (odd && m_kind == Kind::Indices) {
        glEnable(GL_PRIMITIVE_RESTART);
        glDrawElements(GL_TRIANGLES, 7, GL_UNSIGNED_SHORT, kIndices);
        glDisable(GL_PRIMITIVE_RESTART);
      } else {
        glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, kPlain);
      }
    }
  }

  Kind m_kind;
  GLuint m_textures[2] = {};
  std::array<Shape, kShapes> m_shapes{};
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const Name *const chosen = rowNamed(kNames, argc, argv);
  software::Screen screen; // X11 has a Screen too
  if (!chosen || argc != 3 || !screen.open())
    return 1;
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(screen.makePbuffer(kEdge, kEdge), context);
  Scene scene(chosen->kind);
  const int frames = std::atoi(argv[2]);
  for (int i = 0; i < frames; ++i) {
    scene.frame();
    if (i < kFirst) // machine code is made meanwhile
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (i >= frames - kPictures)
      record("frame" + takeErrors(), readRgba(0, 0, kEdge, kEdge));
  }
  screen.destroy(context);
  return 0;
}
