// Texture images that go through ARB_imaging.
#include <type_traits>
#include <utility>

#include "host/host_table.h"
#include "state/client_pixels/plain_transfer.h"
#include "state/core/errors.h"
#include "state/imaging/imaging_state.h"
#include "state/pixel_commands/copy_texture.h"
#include "state/pixel_commands/pixel_commands.h"
#include "state/programs/texture_changes.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

using imaging::ImageKind;
using imaging::Pixels;

static_assert(std::is_trivially_copyable_v<ImageUpload>);

bool isProxy(GLenum target) {
  switch (target) {
  case GL_PROXY_TEXTURE_1D:
  case GL_PROXY_TEXTURE_2D:
  case GL_PROXY_TEXTURE_3D:
  case GL_PROXY_TEXTURE_CUBE_MAP:
  case GL_PROXY_TEXTURE_RECTANGLE:
  case GL_PROXY_TEXTURE_1D_ARRAY:
  case GL_PROXY_TEXTURE_2D_ARRAY:
  case GL_PROXY_TEXTURE_CUBE_MAP_ARRAY:
    return true;
  default:
    return false;
  }
}

/// Returns the kind of an image. CopyTexSubImage3D copies a two-dimensional one.
ImageKind kindOf(const ImageUpload &upload) {
  if (upload.isPlane != 0)
    return ImageKind::Two;
  return upload.dimensions == 1   ? ImageKind::One
         : upload.dimensions == 2 ? ImageKind::Two
                                  : ImageKind::Three;
}

void define(const host::HostTable &host, const ImageUpload &to, const void *pixels) {
  switch (to.dimensions) {
  case 1:
    return host.TexImage1D(to.target, to.level, to.internalFormat, to.width, to.border, GL_RGBA,
                           GL_FLOAT, pixels);
  case 2:
    return host.TexImage2D(to.target, to.level, to.internalFormat, to.width, to.height, to.border,
                           GL_RGBA, GL_FLOAT, pixels);
  default:
    return host.TexImage3D(to.target, to.level, to.internalFormat, to.width, to.height, to.depth,
                           to.border, GL_RGBA, GL_FLOAT, pixels);
  }
}

void replace(const host::HostTable &host, const ImageUpload &to, const void *pixels) {
  switch (to.dimensions) {
  case 1:
    return host.TexSubImage1D(to.target, to.level, to.x, to.width, GL_RGBA, GL_FLOAT, pixels);
  case 2:
    return host.TexSubImage2D(to.target, to.level, to.x, to.y, to.width, to.height, GL_RGBA,
                              GL_FLOAT, pixels);
  default:
    return host.TexSubImage3D(to.target, to.level, to.x, to.y, to.z, to.width, to.height, to.depth,
                              GL_RGBA, GL_FLOAT, pixels);
  }
}

/// Gives the image to the host, whose copy alone is valid afterwards.
void give(RasterContext &context, const ImageUpload &to, const void *pixels) {
  if (context.software && !isProxy(to.target)) {
    if (to.replaces != 0)
      context.software->residency.synchronise("glTexSubImage");
    context.software->residency.textureRedefined(to.target);
  }
  GLenum error = GL_NO_ERROR;
  {
    const PlainTransfer plain(context, PixelStore::Unpack);
    (to.replaces != 0 ? replace : define)(*context.host, to, pixels);
    error = takeHostErrors(*context.host);
  }
  if (error != GL_NO_ERROR)
    raise(context, error, "TexImage: the host refuses it");
  noteTextureChange(context);
}

/// True if the level holds depths. The host then judges the command.
bool hasDepths(const RasterContext &context, GLenum target, GLint level) {
  GLint bits = 0;
  context.host->GetTexLevelParameteriv(target, level, GL_TEXTURE_DEPTH_SIZE, &bits);
  return bits != 0;
}

/// True for formats of CopyTexImage that are depths, or that only TexImage has. The host judges
/// these.
bool isHostsFormat(GLenum format) {
  switch (format) {
  case 1:
  case 2:
  case 3:
  case 4:
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_COMPONENT16:
  case GL_DEPTH_COMPONENT24:
  case GL_DEPTH_COMPONENT32:
  case GL_DEPTH_COMPONENT32F:
  case GL_DEPTH_STENCIL:
  case GL_DEPTH24_STENCIL8:
  case GL_DEPTH32F_STENCIL8:
    return true;
  default:
    return false;
  }
}

} // namespace

void uploadImage(RasterContext &context, const ImageUpload &upload,
                 std::vector<imaging::Rgba> colors) {
  ImagingState &state = *context.imaging;
  ImageUpload to = upload;
  if (upload.hasPixels == 0) {
    convolveSize(state.settings, state.contents, kindOf(upload), to.width, to.height);
    return give(context, to, nullptr);
  }
  Pixels pixels{upload.width, upload.height, upload.depth, std::move(colors)};
  if (upload.indices == 0)
    firstArithmetic(context).apply(pixels);
  const bool remain =
      run(state.settings, state.contents, state.colorMatrix.top(context), kindOf(upload), pixels);
  to.width = pixels.width;
  to.height = pixels.height;
  if (remain || upload.replaces == 0)
    give(context, to, remain ? pixels.texels.data() : nullptr);
}

bool imagedTexImage(RasterContext &context, ImageUpload upload, GLenum format, GLenum type,
                    const void *pixels) {
  const bool records = context.listMode != 0;
  if (context.insideBeginEnd || !isColorFormat(format) ||
      (records ? isProxy(upload.target) : !context.imaging->isActive(context)))
    return false;
  const bool given =
      !isProxy(upload.target) && (pixels || hasPixelBuffer(context, PixelStore::Unpack));
  upload.hasPixels = given && upload.width > 0 && upload.height > 0 && upload.depth > 0 ? 1 : 0;
  upload.indices = format == GL_COLOR_INDEX ? 1 : 0;
  const auto image = unpackPixels(context,
                                  {.dimensions = upload.dimensions,
                                   .width = upload.hasPixels != 0 ? upload.width : 0,
                                   .height = upload.hasPixels != 0 ? upload.height : 0,
                                   .depth = upload.hasPixels != 0 ? upload.depth : 0,
                                   .format = format,
                                   .type = type},
                                  pixels);
  if (!image)
    return true; // the format or the type was an error
  if (!records) {
    uploadImage(context, upload, image->texels);
    return true;
  }
  recordImaging(context, {.kind = ImagingCommand::Kind::TexImage},
                {reinterpret_cast<const char *>(&upload), sizeof upload}, image->texels);
  return true;
}

bool imagedCopyTexture(RasterContext &context, const CopyCommand &copy) {
  const bool defines = copy.kind == CopyKind::Image1D || copy.kind == CopyKind::Image2D;
  if (!context.imaging->isActive(context) ||
      (defines ? isHostsFormat(copy.internalFormat) : hasDepths(context, copy.target, copy.level)))
    return false;
  const CopyRegion &region = copy.region;
  auto pixels = readFramebuffer(context, region.x, region.y, region.width, region.height);
  if (!pixels)
    return true;
  const bool line = copy.kind == CopyKind::Image1D || copy.kind == CopyKind::SubImage1D;
  const bool plane = copy.kind == CopyKind::SubImage3D;
  uploadImage(context,
              {.dimensions = line    ? 1
                             : plane ? 3
                                     : 2,
               .replaces = defines ? 0 : 1,
               .target = copy.target,
               .level = copy.level,
               .internalFormat = GLint(copy.internalFormat),
               .border = copy.border,
               .x = region.destX,
               .y = region.destY,
               .z = region.destZ,
               .width = region.width,
               .height = region.height,
               .hasPixels = 1,
               .isPlane = plane ? 1 : 0},
              std::move(pixels->texels));
  return true;
}

} // namespace arbiter::state
