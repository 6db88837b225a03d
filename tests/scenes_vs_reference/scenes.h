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
/// took their place. Each is computed in plain C++ too.
namespace scenes {

/// Bytes of RGBA, the lowest row first.
using Picture = std::vector<std::uint8_t>;

/// One way to draw a scene.
struct Way {
  const char *name;
  const char *needs; ///< an extension, or two with a space between them
  void (*begin)();   ///< programs and state that stay while it is drawn
  void (*draw)();    ///< a frame
  void (*end)();
};

struct Scene {
  const char *name;
  void (*prepare)(); ///< geometry and textures; the framebuffer is bound
  std::vector<Way> ways;
  struct Canvas (*reference)(int size); ///< null: a benchmark's alone
  int steps;                            ///< of 255 that a pixel may be off
  double outliers;                      ///< the part of the pixels that may be further off
};

[[nodiscard]] Scene furScene();
[[nodiscard]] Scene shadowScene();
[[nodiscard]] Scene skinningScene();

/// The picture's width and height.
[[nodiscard]] int pictureSize();

// --- Geometry ---

struct MeshVertex {
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1};
  glm::vec3 tangent{1, 0, 0};
  glm::vec2 texture{0};
  glm::vec4 extra{0}; ///< texture coordinates 1
};

/// Triangles by index, in buffers of GL's from upload() on.
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;
  GLuint buffers[2] = {};

  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    indices.insert(indices.end(), {a, b, c, a, c, d});
  }
  void upload();
  /// Positions, normals, texture coordinates 0 and, as texture coordinates 2, tangents.
  /// \param extra texture coordinates 1 come from the mesh, and are not the current ones
  void draw(bool extra) const;
};

/// A sphere of radius 1; tangents go down the meridians.
[[nodiscard]] Mesh sphere(int columns, int rows);

// --- GL ---

void loadMatrices(const glm::mat4 &projection, const glm::mat4 &modelView);
/// A new texture, bound to the active unit, with both filters and CLAMP_TO_EDGE or REPEAT.
GLuint newTexture(GLint filter, GLint wrap);
/// A program of ARB's, made, bound and enabled.
GLuint useArbProgram(GLenum target, const char *text);
/// A vertex program of NVIDIA's, the same.
GLuint useNvProgram(const char *text);
void endPrograms();

void combinerInput(GLenum stage, GLenum portion, GLenum variable, GLenum source,
                   GLenum mapping = GL_UNSIGNED_IDENTITY_NV, GLenum usage = GL_RGB);
void combinerOutput(GLenum stage, GLenum portion, GLenum product, GLenum sum);
void finalInput(GLenum variable, GLenum source, GLenum mapping = GL_UNSIGNED_IDENTITY_NV,
                GLenum usage = GL_RGB);

// --- Plain C++ ---

/// A picture with depths that is drawn to by hand, and the pixels of which nothing is decided: a
/// sample falls between two texels.
struct Canvas {
  explicit Canvas(int side, const glm::vec4 &clear);
  int size;
  std::vector<glm::vec4> colors;
  std::vector<double> depths;
  std::vector<bool> undecided;
  [[nodiscard]] Picture bytes() const;
};

} // namespace scenes
