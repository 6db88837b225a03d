#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/pixel_commands/imaging_commands.h"
#include "state/pixel_commands/transfer.h"

/// Commands that move pixels, where ARB_imaging takes part, or where fragments use more of the
/// raster position than hosts provide. They return true if they have executed the command or
/// recorded it in a list.
namespace arbiter::state {

struct CopyCommand;

/// Entry points call these if ContextHot::imagesPixels is set or the rasterizer may draw.
[[nodiscard]] bool imagedDrawPixels(RasterContext &context, GLsizei width, GLsizei height,
                                    GLenum format, GLenum type, const void *pixels);
[[nodiscard]] bool imagedCopyPixels(RasterContext &context, GLint x, GLint y, GLsizei width,
                                    GLsizei height, GLenum type);
[[nodiscard]] bool imagedReadPixels(RasterContext &context, GLint x, GLint y, GLsizei width,
                                    GLsizei height, GLenum format, GLenum type, void *pixels);

/// A TexImage or TexSubImage. A list keeps its bytes.
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
  GLint indices = 0; ///< 1: colour indices, which have no scale and bias
  GLint isPlane = 0; ///< 1: a two-dimensional image for a texture of three
};
/// \param upload all but the members about its pixels
[[nodiscard]] bool imagedTexImage(RasterContext &context, ImageUpload upload, GLenum format,
                                  GLenum type, const void *pixels);
/// Copies from the framebuffer to a texture.
[[nodiscard]] bool imagedCopyTexture(RasterContext &context, const CopyCommand &copy);

// Lists call these too.
void drawImage(RasterContext &context, const ImagingCommand &command,
               const std::vector<imaging::Rgba> &colors);
void copyImage(RasterContext &context, const ImagingCommand &command);
void uploadImage(RasterContext &context, const ImageUpload &upload,
                 std::vector<imaging::Rgba> colors);

} // namespace arbiter::state
