#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/pixel_commands/imaging_commands.h"
#include "state/pixel_commands/transfer.h"

/// The commands that move pixels, where ARB_imaging has a part in it, or fragments have more of the
/// raster position than hosts give them. Each of those that give true
/// has done the command, or recorded it into the list that is compiled.
namespace arbiter::state {

struct CopyCommand;

/// Asked by the entry points where ContextHot::imagesPixels is set or the rasterizer may draw.
[[nodiscard]] bool imagedDrawPixels(Context &context, GLsizei width, GLsizei height, GLenum format,
                                    GLenum type, const void *pixels);
[[nodiscard]] bool imagedCopyPixels(Context &context, GLint x, GLint y, GLsizei width,
                                    GLsizei height, GLenum type);
[[nodiscard]] bool imagedReadPixels(Context &context, GLint x, GLint y, GLsizei width,
                                    GLsizei height, GLenum format, GLenum type, void *pixels);

/// A TexImage or TexSubImage. Plain bytes, in which a list keeps it.
struct ImageUpload {
  GLint dimensions = 2;
  GLint replaces = 0; ///< 1: TexSubImage
  GLenum target = 0;
  GLint level = 0;
  GLint internalFormat = 0;
  GLint border = 0;
  GLint x = 0, y = 0, z = 0;
  GLsizei width = 1, height = 1, depth = 1;
  GLint hasPixels = 0;
  GLint indices = 0; ///< 1: of colour indices, which have no scale and bias
  GLint isPlane = 0; ///< 1: an image of two dimensions for one of three
};
/// \param upload all but what says of its pixels
[[nodiscard]] bool imagedTexImage(Context &context, ImageUpload upload, GLenum format, GLenum type,
                                  const void *pixels);
/// A copy from the framebuffer to a texture.
[[nodiscard]] bool imagedCopyTexture(Context &context, const CopyCommand &copy);

// What a list has of them, too.
void drawImage(Context &context, const ImagingCommand &command,
               const std::vector<imaging::Rgba> &colors);
void copyImage(Context &context, const ImagingCommand &command);
void uploadImage(Context &context, const ImageUpload &upload, std::vector<imaging::Rgba> colors);

} // namespace arbiter::state
