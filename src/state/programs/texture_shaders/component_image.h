#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <GL/gl.h>

/// Images with HILO components or texture offset groups, which the host stores as other formats.
namespace arbiter::state {

class Context;

/// A TexImage or TexSubImage of such components. Plain bytes, in which a list keeps it.
struct ComponentImage {
  GLint dimensions = 2;
  GLint replaces = 0; ///< 1: TexSubImage
  GLenum target = 0;
  GLint level = 0;
  GLenum internalFormat = 0; ///< of TexImage
  GLint border = 0;
  GLint x = 0, y = 0, z = 0; ///< of TexSubImage
  GLsizei width = 1, height = 1, depth = 1;
  GLenum format = 0;
  GLint hasPixels = 0; ///< else TexImage without any: undefined texels
};

/// No side is longer than the host's images can be. Mesa 22.3 writes over its stack at one of 2^28.
[[nodiscard]] bool mayHaveSize(const Context &context, const ComponentImage &image);

/// Executes it, or raises its error: scales and biases (3.6.5), clamps, rounds to the internal
/// format's bits, and gives it to the host, whose image alone is valid then. `pixels` are
/// components as they were unpacked.
void executeComponentImage(Context &context, const ComponentImage &image,
                           std::vector<GLfloat> pixels);
[[nodiscard]] std::string bytesOf(const ComponentImage &image, const std::vector<GLfloat> &pixels);
[[nodiscard]] ComponentImage componentImageOf(const std::string &bytes);
void executeComponentImage(Context &context, const std::string &bytes);

/// Whether the level has an internal format of NV_texture_shader: its name, or 0. Asks which
/// texture is bound.
[[nodiscard]] GLenum componentFormatOf(Context &context, GLenum image, GLint level);
/// Notes the internal format that the level was given; 0: the host's own.
void noteImageFormat(Context &context, GLenum image, GLint level, GLenum internalFormat);

} // namespace arbiter::state
