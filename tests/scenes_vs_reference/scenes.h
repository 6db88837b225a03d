#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

/// Scenes of 2002 and the ways to draw each: by the extensions of those years, and by ARB's, which
/// replaced them. Each is computed in plain C++ too.
namespace scenes {

/// Bytes of RGBA, the bottom row first.
using Picture = std::vector<std::uint8_t>;

/// One way to draw a scene.
struct Way {
  const char *name;
  const char *needs; ///< an extension, or two with a space between them
  void (*begin)();   ///< sets programs and state that stay while it is drawn
  void (*draw)();    ///< draws a frame
  void (*end)();
};

struct Scene {
  const char *name;
  void (*prepare)(); ///< makes geometry and textures; the framebuffer is bound
  std::vector<Way> ways;
  struct Canvas (*reference)(int size); ///< null: only for benchmarks
  int steps;                            ///< allowed difference of a pixel, in 255ths
  double outliers;                      ///< the fraction of pixels that may differ more
};

[[nodiscard]] Scene furScene();
[[nodiscard]] Scene shadowScene();
[[nodiscard]] Scene skinningScene();

/// Returns the picture's width and height.
[[nodiscard]] int pictureSize();

// --- Geometry ---

struct MeshVertex {
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1};
  glm::vec3 tangent{1, 0, 0};
  glm::vec2 texture{0};
  glm::vec4 extra{0}; ///< texture coordinates 1
};

/// Triangles by index, in GL buffers after upload().
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
  GLuint buffers[2] = {};

  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    indices.insert(indices.end(), {a, b, c, a, c, d});
  }
  void upload();
  /// Draws positions, normals, texture coordinates 0 and, as texture coordinates 2, tangents.
  /// \param extra takes texture coordinates 1 from the mesh instead of the current ones
  void draw(bool extra) const;
};

/// Returns a sphere of radius 1; its tangents go down the meridians.
[[nodiscard]] Mesh sphere(int columns, int rows);

// --- GL ---

void loadMatrices(const glm::mat4 &projection, const glm::mat4 &modelView);
/// Makes a texture, bound to the active unit, with both filters and CLAMP_TO_EDGE or REPEAT.
GLuint newTexture(GLint filter, GLint wrap);
/// Makes, binds and enables an ARB program.
GLuint useArbProgram(GLenum target, const char *text);
/// Makes, binds and enables an NVIDIA vertex program.
GLuint useNvProgram(const char *text);
void endPrograms();

void combinerInput(GLenum stage, GLenum portion, GLenum variable, GLenum source,
                   GLenum mapping = GL_UNSIGNED_IDENTITY_NV, GLenum usage = GL_RGB);
void combinerOutput(GLenum stage, GLenum portion, GLenum product, GLenum sum);
void finalInput(GLenum variable, GLenum source, GLenum mapping = GL_UNSIGNED_IDENTITY_NV,
                GLenum usage = GL_RGB);

// --- Plain C++ ---

/// A picture with depths that plain C++ draws to. It marks undecided pixels, whose sample falls
/// between two texels.
struct Canvas {
  explicit Canvas(int side, const glm::vec4 &clear);
  int size;
  std::vector<glm::vec4> colors;
  std::vector<double> depths;
  std::vector<bool> undecided;
  [[nodiscard]] Picture bytes() const;
};

} // namespace scenes
