// TexImage, TexSubImage and GetTexImage: they update the rasterizer's shadows, and handle images in
// formats of NV_texture_shader.
#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/client_pixels/plain_transfer.h"
#include "state/context/context.h"
#include "state/core/depth_images.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/lists/texture_commands.h"
#include "state/pixel_commands/pixel_commands.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/programs/texture_shaders/component_image.h"
#include "state/programs/texture_shaders/component_texels.h"
#include "state/programs/texture_shaders/texture_shader_commands.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/raster_draw/context_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using Size = std::array<GLsizei, 3>;

/// Returns the image of a TexImage.
ComponentImage wholeOf(GLint dimensions, GLenum target, GLint level, GLint internalFormat,
                       const Size &size, GLint border, GLenum format) {
  return {dimensions, 0,       target,  level, GLenum(internalFormat), border, 0, 0, 0,
          size[0],    size[1], size[2], format};
}

/// Returns the image of a TexSubImage.
ComponentImage partOf(GLint dimensions, GLenum target, GLint level, const std::array<GLint, 3> &at,
                      const Size &size, GLenum format) {
  return {dimensions, 1,     target,  level,   0,       0,     at[0],
          at[1],      at[2], size[0], size[1], size[2], format};
}

// --- HILO components and texture offset groups ---

GLenum errorOf(Context &context, const ComponentImage &image, GLenum type) {
  if (const GLenum error = componentTypeError(image.format, type); error != GL_NO_ERROR)
    return error;
  if (image.replaces != 0)
    return GL_NO_ERROR;
  const ComponentFormat *const format =
      componentFormat(image.internalFormat, context.textureShaders->extensions());
  return format && format->external == image.format ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

/// True if the size is allowed, or the level has the texels that are replaced. The application's
/// memory must not be read for a command that the host will refuse.
bool hasRoom(Context &context, const ComponentImage &image) {
  if (image.level < 0 || !mayHaveSize(context, image))
    return false;
  const GLsizei sizes[] = {image.width, image.height, image.depth};
  if (image.replaces == 0 || context.listMode != 0)
    return true;
  const GLint from[] = {image.x, image.y, image.z};
  constexpr GLenum kNames[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH};
  for (int i = 0; i < image.dimensions; ++i) {
    GLint there = 0;
    context.host->GetTexLevelParameteriv(image.target, image.level, kNames[i], &there);
    if (from[i] > there || sizes[i] > there)
      return false;
  }
  return true;
}

void giveComponents(Context &context, ComponentImage image, GLenum type, const void *pixels) {
  if (const GLenum error = errorOf(context, image, type); error != GL_NO_ERROR)
    return raise(context, error, "TexImage: format, type and internal format do not go together");
  if (image.width < 0 || image.height < 0 || image.depth < 0)
    return raise(context, GL_INVALID_VALUE, "TexImage: a size is negative");
  GLint buffer = 0;
  if (context.caps.pixelBuffers)
    context.host->GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &buffer);
  const bool empty = image.width == 0 || image.height == 0 || image.depth == 0;
  image.hasPixels = !empty && (pixels || buffer != 0) && hasRoom(context, image) ? 1 : 0;
  std::vector<GLfloat> components;
  const ComponentPixels from = {
      image.width, image.height, image.depth, componentsOf(image.format), type, image.dimensions};
  if (image.hasPixels != 0 && !unpackComponents(context, from, pixels, components))
    return;
  if (context.listMode == 0 && context.software)
    context.software->residency.textureRedefined(image.target);
  if (context.listMode == 0)
    return executeComponentImage(context, image, std::move(components));
  noteProgramApiUse(context);
  listCompiler(context).record(
      context, {.kind = Command::Kind::ComponentImage, .bytes = bytesOf(image, components)});
}

/// Executes a command that has such components, or mixes them with colours. Returns false
/// otherwise.
bool isComponents(Context &context, const ComponentImage &image, GLenum type, const void *pixels) {
  if (image.format == GL_DUDV_ATI) {
    if (!hasBumpMaps(context))
      return false;
    (void)keepTextures(context);
  }
  if (!context.textureShaders || context.insideBeginEnd) [[likely]]
    return false;
  if (isComponentFormat(image.format)) {
    giveComponents(context, image, type, pixels);
    return true;
  }
  const GLenum name = image.replaces == 0 ? image.internalFormat
                      : context.listMode == 0
                          ? componentFormatOf(context, image.target, image.level)
                          : 0;
  const ComponentFormat *const format = name != 0 ? componentFormat(name) : nullptr;
  if (!isSignedPacked(type) && (!format || format->external == 0))
    return false;
  raise(context, GL_INVALID_OPERATION, "TexImage: format, type and internal format do not match");
  return true;
}

// --- Colours ---

template <typename Host>
void defineColorsAlone(Context &context, GLenum target, GLint level, GLint internalformat,
                       Host host) {
  if (!context.textureShaders || context.insideBeginEnd) [[likely]]
    return host(internalformat);
  context.textureShaders->wholeTextures.clear();
  const ComponentFormat *const own =
      componentFormat(GLenum(internalformat), context.textureShaders->extensions());
  if (!own && !context.group->textureFormats.any()) [[likely]]
    return host(internalformat);
  const TextureShaderCommand format = {.kind = TextureShaderCommand::Kind::Format,
                                       .pname = own ? own->name : 0,
                                       .values = {GLfloat(target), GLfloat(level)}};
  const GLint there = own ? GLint(hostFormat(*own, context.caps)) : internalformat;
  if (context.listMode != 0) {
    host(there);
    noteProgramApiUse(context);
    return listCompiler(context).record(
        context, {.kind = Command::Kind::TextureShaders, .bytes = bytesOf(format)});
  }
  const GLenum earlier = takeHostErrors(*context.host);
  host(there);
  const GLenum error = takeHostErrors(*context.host);
  if (error == GL_NO_ERROR)
    executeTextureShaderCommand(context, format);
  if (earlier != GL_NO_ERROR || error != GL_NO_ERROR)
    raise(context, earlier != GL_NO_ERROR ? earlier : error, "TexImage");
}

/// Uploads the image through ARB_imaging, if it is in use. Returns false if it is not.
bool isImaged(Context &context, const ComponentImage &image, GLint internalFormat, GLenum type,
              const void *pixels) {
  if (!context.imagesPixels) [[likely]]
    return false;
  const ImageUpload upload{image.dimensions, image.replaces, image.target, image.level,
                           internalFormat,   image.border,   image.x,      image.y,
                           image.z,          image.width,    image.height, image.depth};
  return imagedTexImage(context, upload, image.format, type, pixels);
}

/// Executes a TexImage of colours; `host` takes the host's internal format for it.
template <typename Host>
void defineColors(Context &context, GLenum target, GLint level, GLint internalformat, Host host) {
  noteInternalFormat(context, GLenum(internalformat));
  defineColorsAlone(context, target, level, internalformat, host);
  noteTextureCommand(context);
}

/// Executes a TexImage. `colours` handles one of colours, and is told the host's internal format.
template <typename Colors>
void defineImage(Context &context, const ComponentImage &image, GLint internalformat, GLenum type,
                 const void *pixels, Colors colors) {
  if (isComponents(context, image, type, pixels))
    return;
  defineColors(context, image.target, image.level, internalformat, [&](GLint there) {
    if (!isImaged(context, image, there, type, pixels))
      colors(there);
  });
}

/// Executes a TexSubImage; `host` calls the host's command.
template <typename Host>
void replaceImage(Context &context, const ComponentImage &image, GLenum type, const void *pixels,
                  Host host) {
  if (isComponents(context, image, type, pixels) || isImaged(context, image, 0, type, pixels))
    return;
  if (executesPixels(context) && context.software)
    context.software->residency.texSubImage(image.target, image.level, image.x, image.y, image.z,
                                            image.width, image.height, image.depth, image.format,
                                            type, pixels);
  host();
}

// --- GetTexImage ---

GLint sizeOf(const Context &context, GLenum target, GLint level, GLenum pname) {
  GLint value = 0;
  context.host->GetTexLevelParameteriv(target, level, pname, &value);
  return value;
}

/// Gets an image of components as integers. The host has its floats in the format `there`.
void getComponents(Context &context, GLenum target, GLint level, GLenum there, int components,
                   GLenum type, void *pixels) {
  const ComponentPixels to = {sizeOf(context, target, level, GL_TEXTURE_WIDTH),
                              std::max(sizeOf(context, target, level, GL_TEXTURE_HEIGHT), 1),
                              std::max(sizeOf(context, target, level, GL_TEXTURE_DEPTH), 1),
                              components,
                              type,
                              target == GL_TEXTURE_3D ? 3 : 2};
  if (to.width == 0)
    return;
  std::vector<GLfloat> texels(std::size_t(to.width) * std::size_t(to.height) *
                              std::size_t(to.depth) * std::size_t(components));
  {
    const PlainTransfer plain(context, PixelStore::Pack);
    context.host->GetTexImage(target, level, there, GL_FLOAT, texels.data());
  }
  if (pixels || context.caps.pixelBuffers)
    (void)packComponents(context, to, texels, pixels);
}

/// Returns the format for the host's GetTexImage; 0 if the command was an error or is done.
GLenum getFormat(Context &context, GLenum target, GLint level, GLenum format, GLenum type,
                 void *pixels) {
  if (!context.textureShaders || context.insideBeginEnd) [[likely]]
    return format;
  const GLenum name = componentFormatOf(context, target, level);
  const ComponentFormat *const own = name != 0 ? componentFormat(name) : nullptr;
  const GLenum external = own ? own->external : 0;
  if (!isComponentFormat(format) && external == 0 && !isSignedPacked(type)) [[likely]]
    return format;
  if (format != external) {
    raise(context, GL_INVALID_OPERATION, "GetTexImage: the image has no such components");
    return 0;
  }
  if (const GLenum error = componentTypeError(format, type); error != GL_NO_ERROR) {
    raise(context, error, "GetTexImage: the format has no such type");
    return 0;
  }
  constexpr GLenum kFormats[] = {GL_RG, GL_RGB, GL_RGBA};
  const int components = componentsOf(format);
  const GLenum there = kFormats[components - 2];
  if (!isPackedHere(type))
    return there;
  if (context.software)
    context.software->residency.synchronise("glGetTexImage");
  getComponents(context, target, level, there, components, type, pixels);
  return 0;
}

} // namespace

namespace handlers {

void GetTexImage(Context &context, GLenum target, GLint level, GLenum format, GLenum type,
                 void *pixels) {
  const GLenum there = getFormat(context, target, level, format, type, pixels);
  if (there == 0 && format != 0)
    return;
  if (context.executesNow() && context.software) {
    context.software->habits.readsPixels = true;
    if (context.software->residency.getTexImage(target, level, there, type, pixels))
      return;
    context.software->residency.synchronise("glGetTexImage");
  }
  context.host->GetTexImage(target, level, there, type, pixels);
}

void TexImage1D(Context &context, GLenum target, GLint level, GLint internalformat, GLsizei width,
                GLint border, GLenum format, GLenum type, const void *pixels) {
  const ComponentImage image =
      wholeOf(1, target, level, internalformat, {width, 1, 1}, border, format);
  defineImage(context, image, internalformat, type, pixels, [&](GLint there) {
    if (executesPixels(context) && context.software)
      context.software->residency.textureRedefined(target);
    context.host->TexImage1D(target, level, there, width, border, format, type, pixels);
  });
}

void TexImage2D(Context &context, GLenum target, GLint level, GLint internalformat, GLsizei width,
                GLsizei height, GLint border, GLenum format, GLenum type, const void *pixels) {
  const ComponentImage image =
      wholeOf(2, target, level, internalformat, {width, height, 1}, border, format);
  defineImage(context, image, internalformat, type, pixels, [&](GLint there) {
    if (executesPixels(context) && context.software)
      context.software->residency.texImage2D(target, level, there, width, height, border, format,
                                             type, pixels);
    context.host->TexImage2D(target, level, there, width, height, border, format, type, pixels);
  });
}

void TexImage3D(Context &context, GLenum target, GLint level, GLint internalformat, GLsizei width,
                GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
                const void *pixels) {
  const ComponentImage image =
      wholeOf(3, target, level, internalformat, {width, height, depth}, border, format);
  defineImage(context, image, internalformat, type, pixels, [&](GLint there) {
    if (executesPixels(context) && context.software)
      context.software->residency.textureRedefined(target);
    context.host->TexImage3D(target, level, there, width, height, depth, border, format, type,
                             pixels);
  });
}

void TexSubImage1D(Context &context, GLenum target, GLint level, GLint xoffset, GLsizei width,
                   GLenum format, GLenum type, const void *pixels) {
  const ComponentImage image = partOf(1, target, level, {xoffset, 0, 0}, {width, 1, 1}, format);
  replaceImage(context, image, type, pixels, [&] {
    context.host->TexSubImage1D(target, level, xoffset, width, format, type, pixels);
  });
}

void TexSubImage2D(Context &context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                   GLsizei width, GLsizei height, GLenum format, GLenum type, const void *pixels) {
  const ComponentImage image =
      partOf(2, target, level, {xoffset, yoffset, 0}, {width, height, 1}, format);
  replaceImage(context, image, type, pixels, [&] {
    context.host->TexSubImage2D(target, level, xoffset, yoffset, width, height, format, type,
                                pixels);
  });
}

void TexSubImage3D(Context &context, GLenum target, GLint level, GLint xoffset, GLint yoffset,
                   GLint zoffset, GLsizei width, GLsizei height, GLsizei depth, GLenum format,
                   GLenum type, const void *pixels) {
  const ComponentImage image =
      partOf(3, target, level, {xoffset, yoffset, zoffset}, {width, height, depth}, format);
  replaceImage(context, image, type, pixels, [&] {
    context.host->TexSubImage3D(target, level, xoffset, yoffset, zoffset, width, height, depth,
                                format, type, pixels);
  });
}

} // namespace handlers
} // namespace arbiter::state
