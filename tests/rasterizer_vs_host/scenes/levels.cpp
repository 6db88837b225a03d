// Shows which level of a texture each pixel uses: rasterizer-levels SEED COUNT. Each level has a
// color, and so have the faces of a cube map. Triangles with random coordinates, in perspective or
// not, minify them to all levels. Fixed function and programs sample, with a bias, by a quotient or
// at computed coordinates. Writes the pictures as records, which comparisons.py compares.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 128; ///< of the window, in pixels
constexpr int kCells = 8;  ///< squares of two triangles in a row of the window

struct Target {
  const char *name;
  GLenum target;
  int size; ///< edge of level 0, in texels
};
constexpr Target kTargets[] = {{"1D", GL_TEXTURE_1D, 256},
                               {"2D", GL_TEXTURE_2D, 256},
                               {"3D", GL_TEXTURE_3D, 32},
                               {"CUBE", GL_TEXTURE_CUBE_MAP, 256}};
/// The ways of sampling; null: by fixed function.
constexpr const char *kWays[] = {nullptr, "TEX", "TXP", "TXB", "computed"};

class Levels {
public:
  Levels(std::uint64_t seed, const Target &target) : m_random(seed), m_target(target) {
    glGenTextures(1, &m_texture);
    glBindTexture(target.target, m_texture);
    define();
    glTexParameteri(target.target, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glTexParameteri(target.target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      glTexParameteri(target.target, wrap, GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(target.target);
  }
  ~Levels() {
    glDisable(m_target.target);
    glDeleteTextures(1, &m_texture);
  }
  Levels(const Levels &) = delete;
  Levels &operator=(const Levels &) = delete;

  void draw(const std::string &name) {
    for (const char *const way : kWays)
      for (const bool perspective : {false, true}) {
        const GLuint program = way ? use(way) : 0;
        const std::string sampler = setSampler();
        glClear(GL_COLOR_BUFFER_BIT);
        mesh(way && std::string_view(way) == "TXB", perspective);
        record(name + " " + m_target.name + " by " + (way ? way : "fixed function") +
                   (perspective ? " in perspective" : "") + sampler,
               readRgba(0, 0, kEdge, kEdge));
        if (way) {
          glDisable(GL_FRAGMENT_PROGRAM_ARB);
          glDeleteProgramsARB(1, &program);
        }
      }
    record(name + " " + m_target.name + " errors" + takeErrors(), {});
  }

private:
  float real(float low, float high) { return m_random.real(low, high); }

  /// Defines the levels: level n is 25 n red, face n 40 n green.
  void define() const {
    const bool cube = m_target.target == GL_TEXTURE_CUBE_MAP;
    for (int level = 0, size = m_target.size; size != 0; ++level, size /= 2)
      for (int face = 0; face < (cube ? 6 : 1); ++face) {
        const bool isSolid = m_target.target == GL_TEXTURE_3D;
        std::vector<GLubyte> texels(std::size_t(4) * std::size_t(size) * std::size_t(size) *
                                    std::size_t(isSolid ? size : 1));
        for (std::size_t i = 0; i < texels.size(); i += 4) {
          texels[i] = GLubyte(25 * level);
          texels[i + 1] = GLubyte(40 * face);
          texels[i + 3] = 255;
        }
        if (m_target.target == GL_TEXTURE_1D)
          glTexImage1D(GL_TEXTURE_1D, level, GL_RGBA8, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       texels.data());
        else if (isSolid)
          glTexImage3D(GL_TEXTURE_3D, level, GL_RGBA8, size, size, size, 0, GL_RGBA,
                       GL_UNSIGNED_BYTE, texels.data());
        else
          glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(face) : GL_TEXTURE_2D, level,
                       GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
      }
  }

  /// Sets biases and limits of the level, each of them in one state of three.
  std::string setSampler() {
    std::string name;
    const auto some = [&](const char *what, float value, float other) {
      if (!m_random.once(3))
        return other;
      name += std::string(" ") + what;
      return value;
    };
    const GLenum target = m_target.target;
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, some("bias", real(-2, 2), 0));
    glTexParameterf(target, GL_TEXTURE_LOD_BIAS, some("own bias", real(-2, 2), 0));
    glTexParameterf(target, GL_TEXTURE_MIN_LOD, some("least", real(0, 3), -1000));
    glTexParameterf(target, GL_TEXTURE_MAX_LOD, some("most", real(2, 6), 1000));
    glTexParameterf(target, GL_TEXTURE_BASE_LEVEL, some("base", float(m_random.below(3)), 0));
    glTexParameterf(target, GL_TEXTURE_MAX_LEVEL, some("last", float(3 + m_random.below(3)), 1000));
    return name;
  }

  GLuint use(std::string_view way) const {
    const bool computed = way == "computed";
    const std::string text =
        "!!ARBfp1.0\nTEMP at;\nMOV at, fragment.texcoord[0];\n" +
        std::string(computed ? "MUL at.x, at.x, at.y;\nMAD at.yz, at, 0.75, at.zzxx;\n" : "") +
        (computed ? "TEX" : std::string(way)) + " result.color, at, texture[0], " + m_target.name +
        ";\nEND\n";
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    return makeProgram(GL_FRAGMENT_PROGRAM_ARB, text.c_str());
  }

  /// Draws squares whose coordinates are around a place each, and spread further from square to
  /// square.
  void mesh(bool biased, bool perspective) {
    constexpr int kOrder[] = {0, 1, 2, 2, 1, 3};
    glBegin(GL_TRIANGLES);
    for (int cell = 0; cell < kCells * kCells; ++cell) {
      std::array<float, 3> middle{};
      for (float &value : middle)
        value = m_target.target == GL_TEXTURE_CUBE_MAP ? real(-1, 1) : real(0, 1);
      const float reach = std::exp2(real(-6, 2)), bias = biased ? real(-3, 3) : 1;
      for (const int corner : kOrder) {
        const float w = perspective ? real(0.3f, 1.8f) : 1;
        const auto at = [&](int index, int offset) {
          return w * (2 * float(index + offset) / kCells - 1);
        };
        glTexCoord4f(middle[0] + reach * real(-0.5f, 0.5f), middle[1] + reach * real(-0.5f, 0.5f),
                     middle[2] + reach * real(-0.5f, 0.5f), bias);
        glVertex4f(at(cell % kCells, corner & 1), at(cell / kCells, corner >> 1), 0, w);
      }
    }
    glEnd();
  }

  Random m_random;
  const Target &m_target;
  GLuint m_texture = 0;
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const auto draw = [](int seed, auto &screen, GLXDrawable window, bool) {
    const GLXContext context = screen.makeContext();
    screen.makeCurrent(window, context);
    glViewport(0, 0, kEdge, kEdge);
    for (const Target &target : kTargets)
      Levels(std::uint64_t(seed), target).draw("seed " + std::to_string(seed));
    screen.destroy(context);
  };
  return drawSeeds(argc, argv, kEdge, nullptr, draw);
}
