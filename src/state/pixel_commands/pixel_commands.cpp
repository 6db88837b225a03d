#include "state/pixel_commands/pixel_commands.h"

#include "host/host_table.h"
#include "state/client_pixels/plain_transfer.h"
#include "state/core/errors.h"
#include "state/host_draw/prepare_draw.h"
#include "state/imaging/imaging_state.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/pixels.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

using imaging::ImageKind;
using imaging::Pixels;
using imaging::Rgba;

/// True if ARB_imaging changes or counts pixels now.
bool isImaged(RasterContext &context) {
  return context.imagesPixels && context.imaging->isActive(context);
}

/// True if a command that draws pixels is the layer's: it is executed now, or recorded in a list.
bool isOurs(RasterContext &context) {
  if (context.listMode != 0)
    return context.imagesPixels;
  return isImaged(context) || shadesRasterValues(context);
}

/// Runs the pixel transfer with ARB_imaging. Returns false if a sink has taken the pixels.
bool process(RasterContext &context, ImageKind kind, bool indices, Pixels &pixels) {
  if (!indices)
    firstArithmetic(context).apply(pixels);
  if (!context.imagesPixels)
    return true;
  ImagingState &state = *context.imaging;
  return run(state.settings, state.contents, state.colorMatrix.top(context), kind, pixels);
}

/// Draws pixels at the raster position, without further transfer.
void draw(RasterContext &context, const char *command, const Pixels &pixels) {
  if (shadesRasterValues(context) && tryPixels(context, pixels))
    return;
  if (context.softwareListens)
    hostWrites(context, command);
  ++*context.drawCounter;
  if (pixels.count() == 0)
    return;
  GLenum error = GL_NO_ERROR;
  {
    const PlainTransfer plain(context, PixelStore::Unpack);
    context.host->DrawPixels(pixels.width, pixels.height, GL_RGBA, GL_FLOAT, pixels.texels.data());
    error = takeHostErrors(*context.host);
  }
  if (error != GL_NO_ERROR)
    raise(context, error, command);
}

/// True if reads are clamped to 0 to 1 for any type (ARB_color_buffer_float). FIXED_ONLY clamps
/// unless the framebuffer holds floats.
bool clampsReads(const RasterContext &context) {
  const host::HostTable &host = *context.host;
  GLint clamp = GL_FIXED_ONLY, framebuffer = 0, type = GL_UNSIGNED_NORMALIZED, buffer = 0;
  if (context.caps.clampColor)
    host.GetIntegerv(GL_CLAMP_READ_COLOR, &clamp);
  if (clamp != GL_FIXED_ONLY || !context.caps.framebufferObjects)
    return clamp != GL_FALSE;
  host.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
  host.GetIntegerv(GL_READ_BUFFER, &buffer);
  if (framebuffer != 0)
    host.GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GLenum(buffer),
                                             GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
  return type != GL_FLOAT;
}

/// Sets luminance to the sum of red, green and blue (OpenGL 2.1, 4.3.2, Conversion to L).
void sumLuminance(Pixels &pixels) {
  for (Rgba &texel : pixels.texels)
    texel = {texel[0] + texel[1] + texel[2], 0, 0, texel[3]};
}

} // namespace

bool imagedDrawPixels(RasterContext &context, GLsizei width, GLsizei height, GLenum format,
                      GLenum type, const void *pixels) {
  if (context.insideBeginEnd || !isColorFormat(format) || !isOurs(context))
    return false;
  const auto image = unpackPixels(
      context, {.width = width, .height = height, .format = format, .type = type}, pixels);
  if (!image)
    return true;
  const ImagingCommand command{.kind = ImagingCommand::Kind::DrawPixels,
                               .flag = format == GL_COLOR_INDEX,
                               .width = width,
                               .height = height};
  if (context.listMode != 0)
    recordImaging(context, command, {}, image->texels);
  else
    drawImage(context, command, image->texels);
  return true;
}

void drawImage(RasterContext &context, const ImagingCommand &command,
               const std::vector<Rgba> &colors) {
  if (!preparePixels(context))
    return;
  Pixels pixels{command.width, command.height, 1, colors};
  if (process(context, ImageKind::Two, command.flag, pixels))
    draw(context, "glDrawPixels", pixels);
}

bool imagedCopyPixels(RasterContext &context, GLint x, GLint y, GLsizei width, GLsizei height,
                      GLenum type) {
  if (context.insideBeginEnd || type != GL_COLOR || !isOurs(context))
    return false;
  const ImagingCommand command{.kind = ImagingCommand::Kind::CopyPixels,
                               .pname = type,
                               .x = x,
                               .y = y,
                               .width = width,
                               .height = height};
  if (context.listMode != 0)
    recordImaging(context, command, {}, {});
  else
    copyImage(context, command);
  return true;
}

void copyImage(RasterContext &context, const ImagingCommand &command) {
  if (!preparePixels(context))
    return;
  if (!isImaged(context) && !shadesRasterValues(context)) {
    if (context.softwareListens)
      hostWrites(context, "glCopyPixels");
    ++*context.drawCounter;
    return context.host->CopyPixels(command.x, command.y, command.width, command.height,
                                    command.pname);
  }
  auto pixels = readFramebuffer(context, command.x, command.y, command.width, command.height);
  if (pixels && process(context, ImageKind::Two, false, *pixels))
    draw(context, "glCopyPixels", *pixels);
}

bool imagedReadPixels(RasterContext &context, GLint x, GLint y, GLsizei width, GLsizei height,
                      GLenum format, GLenum type, void *pixels) {
  if (context.insideBeginEnd || !isColorFormat(format) || format == GL_COLOR_INDEX ||
      !context.imaging->isActive(context))
    return false;
  auto image = readFramebuffer(context, x, y, width, height);
  if (!image || !process(context, ImageKind::Two, false, *image))
    return true;
  const bool clamps = clampsReads(context);
  if (clamps)
    for (Rgba &texel : image->texels)
      texel = imaging::clamped(texel);
  if (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA)
    sumLuminance(*image);
  if (clamps)
    for (Rgba &texel : image->texels)
      texel = imaging::clamped(texel);
  (void)packPixels(context, *image, format, type, pixels);
  return true;
}

} // namespace arbiter::state
