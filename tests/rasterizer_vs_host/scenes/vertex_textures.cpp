// Draws meshes that a vertex program displaces and colors by a texture: rasterizer-vertex-textures
// SEED COUNT. Each seed is a random sequence of definitions, texels, feedback, draws to the
// texture, changed levels and samplers, and deletions. It draws by arrays, by Begin and End, from
// display lists and with many vertices. Writes the results as records, which comparisons.py
// compares. With a third argument, "finish", it waits for its draws to textures.
#include <cstdio>
#include <cstdlib>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 64; // of the window, in pixels
constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP,
                               GL_TEXTURE_RECTANGLE};
constexpr const char *kNames[] = {"1D", "2D", "3D", "CUBE", "RECT"};
constexpr const char *kOpcodes[] = {"TEX", "TXP", "TXL", "TXB"};
constexpr std::size_t k2d = 1, kCube = 3, kRect = 4;
constexpr int kUnits[] = {0, 3}; ///< both are sampled, the first by fragments too

struct Vertex {
  float position[2];
  float texcoord[4];
};

/// Makes `cells` by `cells` squares around the middle. Positions are whole pixels, or quarters, so
/// that all rasterizers cover the same. Texture coordinates are the middles of texels of an image
/// of `edge` texels; q depends on the opcode.
std::vector<Vertex> meshOf(std::size_t target, int cells, int edge, float q) {
  std::vector<Vertex> vertices;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) {
      float s = (float(x % edge) + 0.5f) / float(edge), t = (float(y % edge) + 0.5f) / float(edge);
      float r = (float(edge / 2) - 0.5f) / float(edge);
      if (target == kRect) {
        s *= float(edge);
        t *= float(edge);
      } else if (target == kCube) {
        s = 2 * s - 1;
        t = 2 * t - 1;
        r = x % 2 ? 1.0f : -1.0f;
      }
      const float step = cells > 16 ? 1.0f / 128 : 1.0f / 8;
      vertices.push_back(
          {{float(x - cells / 2) * step, float(y - cells / 2) * step}, {s, t, r, q}});
    }
  return vertices;
}

std::vector<GLuint> trianglesOf(int cells) {
  std::vector<GLuint> indices;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const auto a = GLuint(y * (cells + 1) + x), c = a + GLuint(cells) + 1;
      indices.insert(indices.end(), {a, a + 1, c, c, a + 1, c + 1});
    }
  return indices;
}

class Sequence {
public:
  Sequence(std::uint64_t seed, bool finishes, Screen &screen, GLXDrawable window)
      : m_random(seed), m_finishes(finishes), m_screen(screen), m_context(screen.makeContext()) {
    screen.makeCurrent(window, m_context);
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
    glShadeModel(GL_FLAT); // so that copies to textures have the same bytes
    glEnable(GL_VERTEX_PROGRAM_ARB);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    m_plain = makeProgram(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\nMOV result.color, fragment.color;"
                                                   "\nEND\n");
    m_sampling = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                             "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                             "MAD result.color, t, 0.3713, fragment.color;\nEND\n");
    m_copying =
        makeProgram(GL_VERTEX_PROGRAM_ARB, "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                                           "MOV result.color, vertex.color;\nEND\n");
    glGenFramebuffers(1, &m_framebuffer);
    glGenTextures(5, m_named);
    for (std::size_t i = 0; i < 5; ++i) {
      bind(i);
      define(i);
    }
  }
  ~Sequence() { m_screen.destroy(m_context); }
  Sequence(const Sequence &) = delete;
  Sequence &operator=(const Sequence &) = delete;

  void run(const std::string &name) {
    glClear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 40; ++i)
      command(name + " after " + std::to_string(i));
    record(name + " at the end", readRgba(0, 0, kEdge, kEdge));
    record(name + " errors" + takeErrors(), {});
  }

private:
  void bind(std::size_t target) {
    for (const int unit : kUnits) {
      glActiveTexture(GL_TEXTURE0 + GLenum(unit));
      glBindTexture(kTargets[target], m_named[target]);
    }
    glActiveTexture(GL_TEXTURE0);
  }

  [[nodiscard]] std::vector<float> texels(int count) {
    std::vector<float> values;
    for (int i = 0; i < 4 * count; ++i)
      values.push_back(float(m_random.below(256)) / 255);
    return values;
  }

  void define(std::size_t target) {
    constexpr GLint kFormats[] = {
        GL_RGBA8,       GL_RGB8, GL_LUMINANCE8, GL_RGBA32F_ARB, GL_LUMINANCE8_ALPHA8,
        GL_RGBA16F_ARB, GL_RGBA8};
    const GLenum name = kTargets[target];
    const int edge = m_edge[target] = 8 << m_random.below(2);
    m_mipmaps[target] = target != kRect && m_random.once(2);
    // Draws to it need a format that every host can draw to.
    const GLint internal = target == k2d && m_random.once(2) ? GL_RGBA8 : m_random.pick(kFormats);
    for (int level = 0, size = edge; level == 0 || (m_mipmaps[target] && size > 0);
         ++level, size /= 2) {
      const auto data = texels(size * size * size);
      if (target == 0)
        glTexImage1D(name, level, internal, size, 0, GL_RGBA, GL_FLOAT, data.data());
      else if (target == 2)
        glTexImage3D(name, level, internal, size, size, size, 0, GL_RGBA, GL_FLOAT, data.data());
      else if (target == kCube)
        for (GLenum face = 0; face < 6; ++face)
          glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, internal, size, size, 0,
                       GL_RGBA, GL_FLOAT, data.data() + std::size_t(face) % data.size() / 4 * 4);
      else
        glTexImage2D(name, level, internal, size, size, 0, GL_RGBA, GL_FLOAT, data.data());
    }
    setSampler(target);
    glTexParameteri(name, GL_TEXTURE_BASE_LEVEL, 0);
  }

  void setSampler(std::size_t target) {
    const GLenum name = kTargets[target];
    const GLint plain = m_random.once(2) ? GL_NEAREST : GL_LINEAR;
    glTexParameteri(name, GL_TEXTURE_MIN_FILTER,
                    m_mipmaps[target] ? GL_NEAREST_MIPMAP_NEAREST : plain);
    glTexParameteri(name, GL_TEXTURE_MAG_FILTER, m_mipmaps[target] ? GL_NEAREST : plain);
    const bool ends = target >= kCube || m_random.once(2);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      glTexParameteri(name, wrap, ends ? GL_CLAMP_TO_EDGE : GL_REPEAT);
  }

  [[nodiscard]] GLenum imageOf(std::size_t target) {
    return target == kCube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(m_random.below(6))
                           : kTargets[target];
  }

  void give(std::size_t target) {
    const auto data = texels(64);
    const GLenum image = imageOf(target);
    const GLint level = m_mipmaps[target] ? m_random.below(2) : 0;
    if (target == 0)
      glTexSubImage1D(image, level, m_random.below(2), 3, GL_RGBA, GL_FLOAT, data.data());
    else if (target == 2)
      glTexSubImage3D(image, level, 1, 0, m_random.below(2), 3, 4, 1, GL_RGBA, GL_FLOAT,
                      data.data());
    else
      glTexSubImage2D(image, level, 0, m_random.below(2), 4, 3, GL_RGBA, GL_FLOAT, data.data());
  }

  void feedback(std::size_t target) {
    const GLenum image = imageOf(target);
    const int x = m_random.below(kEdge - 8), y = m_random.below(kEdge - 8);
    if (target == 0)
      glCopyTexSubImage1D(image, 0, 0, x, y, 4);
    else if (target == 2)
      glCopyTexSubImage3D(image, 0, 0, 0, m_random.below(4), x, y, 4, 4);
    else
      glCopyTexSubImage2D(image, 0, 0, 0, x, y, 8, 8);
  }

  /// Draws to the 2D texture, or clears it, directly before it is sampled.
  void drawTo() {
    const GLint level = m_mipmaps[k2d] ? m_random.below(2) : 0;
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_named[k2d],
                           level);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) {
      const int edge = m_edge[k2d] >> level;
      glViewport(0, 0, edge, edge);
      if (m_random.once(3)) {
        glClearColor(float(m_random.below(5)) / 4, float(m_random.below(5)) / 4, 0.5f, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glClearColor(0, 0, 0, 0);
      }
      glBindProgramARB(GL_VERTEX_PROGRAM_ARB, m_copying);
      glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_plain);
      const int count = m_random.below(4);
      for (int i = 0; i < count; ++i) {
        const float x = float(m_random.below(4)) / 2 - 1, y = float(m_random.below(4)) / 2 - 1;
        glBegin(GL_TRIANGLE_STRIP);
        for (int corner = 0; corner < 4; ++corner) {
          glColor4f(float(m_random.below(256)) / 255, float(m_random.below(256)) / 255, 0.25f, 1);
          glVertex2f(x + float(corner % 2), y + float(corner / 2));
        }
        glEnd();
      }
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, kEdge, kEdge);
    if (m_finishes)
      glFinish();
  }

  [[nodiscard]] GLuint programFor(std::size_t target, std::size_t opcode, std::size_t unit) {
    GLuint &program = m_programs[target][opcode][unit];
    if (program == 0)
      program = makeProgram(
          GL_VERTEX_PROGRAM_ARB,
          std::string("!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP d, m, p;\n") +
              kOpcodes[opcode] + " d, vertex.texcoord[0], texture[" + std::to_string(kUnits[unit]) +
              "], " + kNames[target] +
              ";\nMOV p, vertex.position;\nMUL m, d, 7.77;\nFLR m, m;\nMAD p.xy, m, 0.03125, "
              "p;\nMOV result.position, p;\n"
              "MOV result.color, d;\nMOV result.texcoord[0], {0.4375, 0.3125, 0, 1};\nEND\n");
    return program;
  }

  void drawIn(int how, const std::vector<Vertex> &mesh, const std::vector<GLuint> &indices) {
    if (how == 0) {
      glBegin(GL_TRIANGLES);
      for (const GLuint index : indices) {
        glTexCoord4fv(mesh[index].texcoord);
        glVertex2fv(mesh[index].position);
      }
      glEnd();
      return;
    }
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glVertexPointer(2, GL_FLOAT, sizeof(Vertex), mesh.data()->position);
    glTexCoordPointer(4, GL_FLOAT, sizeof(Vertex), mesh.data()->texcoord);
    if (how == 1)
      glDrawElements(GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_INT, indices.data());
    else
      glDrawArrays(GL_TRIANGLE_STRIP, 0, GLsizei(mesh.size()));
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }

  void draw(std::size_t target) {
    const auto opcode = std::size_t(m_random.below(4)), unit = std::size_t(m_random.below(2));
    // Fragments also sample the middle of a texel of 8, so that hosts do not interpolate.
    // q is a divisor, a level, or unused by the opcode.
    const float q = opcode == 1 ? 1 : float(m_random.below(4) - 1);
    const bool large = m_random.once(12);
    const int cells = large ? 150 : m_random.between(2, 9);
    const auto mesh = meshOf(target, cells, m_edge[target], q);
    const auto indices = trianglesOf(cells);
    glBindProgramARB(GL_VERTEX_PROGRAM_ARB, programFor(target, opcode, unit));
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB,
                     target == k2d && m_edge[k2d] == 8 && m_random.once(3) ? m_sampling : m_plain);
    if (large || !m_random.once(3))
      return drawIn(large ? 1 : m_random.below(3), mesh, indices);
    // A list is drawn more than once, with other texels each time.
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    drawIn(m_random.below(2), mesh, indices);
    glEndList();
    glCallList(list);
    if (target == k2d) {
      const GLuint fragments = m_random.once(2) && m_edge[k2d] == 8 ? m_sampling : m_plain;
      drawTo();
      glBindProgramARB(GL_VERTEX_PROGRAM_ARB, programFor(target, opcode, unit));
      glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, fragments);
    } else {
      give(target);
    }
    glCallList(list);
    glDeleteLists(list, 1);
  }

  void command(const std::string &at) {
    const auto target = m_random.once(2) ? k2d : std::size_t(m_random.below(5));
    bind(target);
    switch (m_random.below(14)) {
    case 0:
      return define(target);
    case 1:
    case 2:
      return give(target);
    case 3:
      return feedback(target);
    case 4:
    case 5:
      return drawTo();
    case 6:
      return setSampler(target);
    case 7: {
      const bool second = m_mipmaps[target] && m_random.once(2);
      glTexParameteri(kTargets[target], GL_TEXTURE_BASE_LEVEL, second ? 1 : 0);
      return;
    }
    case 8:
      if (m_random.once(2)) {
        glDeleteTextures(1, &m_named[target]); // the target's texture 0 is incomplete
        glGenTextures(1, &m_named[target]);
        draw(target);
        bind(target);
        define(target);
      } else if (target != kRect && m_mipmaps[target]) {
        glGenerateMipmap(kTargets[target]);
      }
      return;
    default:
      draw(target);
      if (m_random.once(4))
        record(at, readRgba(0, 0, kEdge, kEdge));
      if (m_random.once(4))
        glClear(GL_COLOR_BUFFER_BIT);
    }
  }

  Random m_random;
  const bool m_finishes;
  Screen &m_screen;
  GLXContext m_context;
  GLuint m_plain = 0, m_sampling = 0, m_copying = 0, m_framebuffer = 0;
  GLuint m_named[5] = {}, m_programs[5][4][2] = {};
  int m_edge[5] = {};
  bool m_mipmaps[5] = {};
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  return drawSeeds(
      argc, argv, kEdge, "finish",
      [](int seed, software::Screen &screen, GLXDrawable window, bool finishes) {
        Sequence(std::uint64_t(seed), finishes, screen, window).run("seed " + std::to_string(seed));
      });
}
