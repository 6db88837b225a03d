#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <GL/gl.h>

/// Images with HILO components or texture offset groups, which the host stores in other formats.
namespace arbiter::state {

struct ProgramContext;

/// A TexImage or TexSubImage of such components. It consists of plain bytes, which a list stores.
struct ComponentImage {
  GLint dimensions = 2;
  GLint replaces = 0; ///< 1: this is a TexSubImage
  GLenum target = 0;
  GLint level = 0;
  GLenum internalFormat = 0; ///< for TexImage
  GLint border = 0;
  GLint x = 0, y = 0, z = 0; ///< for TexSubImage
  GLsizei width = 1, height = 1, depth = 1;
  GLenum format = 0;
  GLint hasPixels = 0; ///< 0: TexImage without pixels, whose texels are undefined
};

/// True if no side is longer than the host's images can be. Mesa 22.3 overwrites its stack at a
/// side of 2^28.
[[nodiscard]] bool mayHaveSize(const ProgramContext &context, const ComponentImage &image);

/// Executes the command, or raises its error. It applies scales and biases (3.6.5), clamps, rounds
/// to the internal format's bits, and passes the pixels to the host. Only the host's image is valid
/// then. `pixels` are the unpacked components.
void executeComponentImage(ProgramContext &context, const ComponentImage &image,
                           std::vector<GLfloat> pixels);
[[nodiscard]] std::string bytesOf(const ComponentImage &image, const std::vector<GLfloat> &pixels);
[[nodiscard]] ComponentImage componentImageOf(const std::string &bytes);
void executeComponentImage(ProgramContext &context, const std::string &bytes);

/// Returns the level's internal format if it is one of NV_texture_shader's, or 0. Queries which
/// texture is bound.
[[nodiscard]] GLenum componentFormatOf(ProgramContext &context, GLenum image, GLint level);
/// Notes a level's internal format; 0: one of the host's own.
void noteImageFormat(ProgramContext &context, GLenum image, GLint level, GLenum internalFormat);

} // namespace arbiter::state
