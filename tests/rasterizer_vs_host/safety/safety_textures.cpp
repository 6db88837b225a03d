#include "safety.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace software {

namespace {

constexpr std::array<GLenum, 5> kWraps = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER,
                                          GL_MIRRORED_REPEAT};
constexpr std::array<GLenum, 3> kFilters = {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR};

void fetch(const char *instruction, const char *target) {
  useFragments(std::string(instruction) + " result.color, fragment.texcoord[0], texture[0], " +
               target + ";\n");
}

/// Makes a small mipmapped texture of `target`.
void makeTexture(GLenum target, int side) {
  GLuint name = 0;
  const std::vector<unsigned char> texels(std::size_t(side) * std::size_t(side) * 8 * 4, 90);
  glGenTextures(1, &name);
  glBindTexture(target, name);
  if (target != GL_TEXTURE_RECTANGLE_ARB)
    glTexParameteri(target, GL_GENERATE_MIPMAP, GL_TRUE);
  if (target == GL_TEXTURE_1D) {
    glTexImage1D(target, 0, GL_RGBA8, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  } else if (target == GL_TEXTURE_3D) {
    glTexImage3D(target, 0, GL_RGBA8, side, side, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  } else if (target == GL_TEXTURE_CUBE_MAP) {
    for (GLenum face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, side, side, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, texels.data());
  } else {
    glTexImage2D(target, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
}

struct Kind {
  GLenum target;
  const char *name;
};
constexpr std::array<Kind, 5> kKinds = {{{GL_TEXTURE_1D, "1D"},
                                         {GL_TEXTURE_2D, "2D"},
                                         {GL_TEXTURE_3D, "3D"},
                                         {GL_TEXTURE_CUBE_MAP, "CUBE"},
                                         {GL_TEXTURE_RECTANGLE_ARB, "RECT"}}};

/// Uses NaN, infinite and huge coordinates with every target, wrap and filter.
void oddCoordinates() {
  static constexpr float kInf = std::numeric_limits<float>::infinity();
  for (const Kind &kind : kKinds) {
    const bool rectangle = kind.target == GL_TEXTURE_RECTANGLE_ARB;
    makeTexture(kind.target, 8);
    for (const GLenum wrap : kWraps) {
      if (rectangle && (wrap == GL_REPEAT || wrap == GL_MIRRORED_REPEAT))
        continue;
      for (const GLenum filter : kFilters) {
        if (rectangle && filter == GL_LINEAR_MIPMAP_LINEAR)
          continue;
        glTexParameteri(kind.target, GL_TEXTURE_WRAP_S, GLint(wrap));
        glTexParameteri(kind.target, GL_TEXTURE_WRAP_T, GLint(wrap));
        glTexParameteri(kind.target, GL_TEXTURE_WRAP_R, GLint(wrap));
        glTexParameteri(kind.target, GL_TEXTURE_MIN_FILTER, GLint(filter));
        for (const char *instruction : {"TEX", "TXP", "TXB"}) {
          fetch(instruction, kind.name);
          for (const float odd : {kInf, -kInf, kInf - kInf, 3e38f, -3e38f, 1e15f, -4e9f, 2.2e9f})
            wholeQuad(odd, -odd, 0.5f, odd);
        }
      }
    }
    note(kind.name);
  }
}

/// Samples one texel in all ways, then textures whose sizes are not powers of two.
void sizes() {
  fetch("TEX", "2D");
  for (const auto &[width, height] : {std::pair(1, 1), {1, 64}, {3, 5}, {63, 65}, {130, 1}}) {
    smoothTexture(width, height);
    for (const GLenum wrap : kWraps) {
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GLint(wrap));
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GLint(wrap));
      wholeQuad(0.0004f, 0.0004f, 1.0004f, 1.0004f);
      picture(std::to_string(width) + "x" + std::to_string(height));
    }
  }
}

void large() {
  fetch("TEX", "2D");
  smoothTexture(4096, 4096);
  // Each pixel shows one texel, at the corners and in the middle.
  for (const float from : {0.0f, 0.5f, 1.0f - kSide / 4096.0f}) {
    wholeQuad(from, from, from + kSide / 4096.0f, from + kSide / 4096.0f);
    picture("4096x4096");
  }
}

/// Draws to a framebuffer that is much larger than the window.
void largeTarget() {
  constexpr int kLarge = 4096;
  makeFramebuffer(smoothTexture(kLarge, kLarge));
  glBindTexture(GL_TEXTURE_2D, 0);
  glViewport(0, 0, kLarge, kLarge);
  useFragments("MUL result.color, fragment.color, {0.5, 1, 0.25, 1};\n");
  glColor4ub(255, 120, 255, 255);
  wholeQuad();
  record("picture large target", readRgba(kLarge - kSide, kLarge - kSide, kSide, kSide));
  note("large target");
}

void incomplete() {
  fetch("TEX", "2D");
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name); // it has no image
  wholeQuad();
  picture("no image");
  smoothTexture(16, 16, GL_LINEAR_MIPMAP_LINEAR); // it has one level of five
  wholeQuad();
  picture("one level");
  smoothTexture(16, 16);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 3);
  wholeQuad();
  picture("no base level");
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  wholeQuad();
  picture("no size");
  fetch("TEX", "CUBE"); // one face has another size
  makeTexture(GL_TEXTURE_CUBE_MAP, 8);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_GENERATE_MIPMAP, GL_FALSE);
  glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               nullptr);
  wholeQuad(-1, -1, 1, 1);
  picture("unequal faces");
}

/// Uses a vertex program that moves vertices by a sample. Returns false if the language is missing,
/// as on the bare host, which then raises no errors either.
bool useSamplingVertices(const char *instruction, const char *target) {
  const auto *const extensions = reinterpret_cast<const char *>(glGetString(GL_EXTENSIONS));
  if (!extensions || !std::strstr(extensions, "GL_NV_vertex_program3 ")) {
    if (std::getenv("SAFETY_NEEDS"))
      std::abort();
    return false;
  }
  (void)makeProgram(GL_VERTEX_PROGRAM_ARB,
                    std::string("!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP t;\n") + instruction +
                        " t, vertex.texcoord[0], texture[0], " + target +
                        ";\nMAD result.position, t, {0.5, 0.5, 0, 0}, vertex.position;\n"
                        "MOV result.color, t;\nMOV result.texcoord[0], t;\nEND\n");
  glEnable(GL_VERTEX_PROGRAM_ARB);
  return true;
}

/// Samples in a vertex program with arbitrary coordinates and levels, missing and deleted images,
/// and one that is drawn to.
void sampledByVertices() {
  static constexpr float kInf = std::numeric_limits<float>::infinity();
  useFragments("MOV result.color, fragment.color;\n");
  for (const Kind &kind : kKinds) {
    makeTexture(kind.target, 8);
    for (const char *instruction : {"TEX", "TXP", "TXL", "TXB"}) {
      if (!useSamplingVertices(instruction, kind.name))
        continue;
      glBegin(GL_QUADS);
      for (const float odd : {kInf, -kInf, kInf - kInf, 3e38f, -3e38f, 1e15f, -4e9f, 2.2e9f})
        for (int corner = 0; corner < 4; ++corner) {
          glTexCoord4f(corner == 0 ? odd : 0.3f, corner == 1 ? odd : 0.6f, corner == 2 ? odd : 0,
                       corner == 3 ? odd : 1);
          glVertex2f(corner == 1 || corner == 2 ? 1 : -1, corner > 1 ? 1 : -1);
        }
      glEnd();
    }
    note(std::string("vertices, ") + kind.name);
  }
  const GLuint texture = smoothTexture(kSide, kSide);
  if (useSamplingVertices("TXL", "2D")) {
    wholeQuad();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 3);
    wholeQuad();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
    const GLuint framebuffer = makeFramebuffer(texture);
    for (int i = 0; i < 4; ++i)
      wholeQuad(0.1f, 0, 1.1f, 1);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 16, 16, 0);
    wholeQuad();
    glDeleteFramebuffers(1, &framebuffer);
    wholeQuad();
  }
  glDeleteTextures(1, &texture);
  wholeQuad();
  note("vertices, deleted");
}

/// Draws undefined pictures: only the process must survive.
void feedbackOntoItself() {
  makeFramebuffer(smoothTexture(kSide, kSide));
  fetch("TEX", "2D");
  for (int i = 0; i < 4; ++i)
    wholeQuad(0.1f, 0, 1.1f, 1);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 5, 0, 0, kSide - 3, kSide - 5);
  wholeQuad();
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 16, 16, 0);
  wholeQuad();
  note("feedback");
}

} // namespace

const std::vector<Hazard> kTextureHazards = {
    {"odd-coordinates", oddCoordinates},
    {"sizes", sizes},
    {"large-texture", large},
    {"large-target", largeTarget},
    {"incomplete", incomplete},
    {"feedback-onto-itself", feedbackOntoItself},
    {"sampled-by-vertices", sampledByVertices},
};

} // namespace software
