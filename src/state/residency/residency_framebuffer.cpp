// Queries the attachments of the draw and read framebuffers.
#include <algorithm>

#include "state/residency/residency_host.h"

#include "state/capabilities/host_integer.h"

namespace arbiter::state {

namespace {

/// True for luminance, alpha and intensity. ReadPixels and copies take other components of such
/// buffers than blending and sampling do, so they are the host's.
bool readsAsOther(GLenum base) {
  return base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA || base == GL_ALPHA ||
         base == GL_INTENSITY;
}

/// Returns the attached image, or null if there is none or it can have no shadow (sets `foreign`).
/// `slice` is the slice of a 3D texture, else 0.
PixelImage *attached(ResidentImages &images, GLenum framebuffer, GLenum attachment, bool &foreign,
                     int &slice) {
  const host::HostTable &host = *images.hot.host;
  const auto ask = [&](GLenum pname) {
    GLint value = 0;
    host.GetFramebufferAttachmentParameteriv(framebuffer, attachment, pname, &value);
    return value;
  };
  const GLint type = ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
  if (type == GL_NONE)
    return nullptr;
  const auto name = GLuint(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
  PixelImage *image = nullptr;
  // A deleted object lives on where it is attached, without a name. Binding its name would make
  // another object, or find the one that has the name now.
  const auto kind =
      type == GL_RENDERBUFFER ? DeletedNames::Kind::Renderbuffer : DeletedNames::Kind::Texture;
  if (!images.deletedNames.none()) {
    const GLint bound =
        hostInteger(host, framebuffer == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING
                                                             : GL_DRAW_FRAMEBUFFER_BINDING);
    if (!images.deletedNames.isAttached(images.serial, GLuint(bound), attachment, kind, name)) {
      foreign = true;
      return nullptr;
    }
  }
  if (type == GL_RENDERBUFFER) {
    if (host.IsRenderbuffer(name))
      image = &renderbufferOf(images, name);
  } else if (type == GL_TEXTURE && host.IsTexture(name)) {
    const GLint level = ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
    const auto face = GLenum(ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE));
    Texture &texture = textureOf(images.objects, 0, name);
    const GLenum target = face != 0 ? face : findTarget(images, texture);
    if (target == GL_TEXTURE_3D)
      slice = ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER);
    image = levelOf(images, texture, target, level);
    if (image && (slice < 0 || slice >= image->depth))
      image = nullptr;
  }
  if (image && image->base != 0)
    return image;
  foreign = true;
  return nullptr;
}

/// Returns the image of a draw buffer. Null, with `foreign` set, if it can have no shadow.
PixelImage *windowBuffer(ResidentImages &images, GLenum buffer, bool &foreign) {
  const bool back = buffer == GL_BACK || buffer == GL_BACK_LEFT;
  const bool front = buffer == GL_FRONT || buffer == GL_FRONT_LEFT || buffer == GL_LEFT;
  if (images.color.base != 0 && (images.doubleBuffered ? back : front || back))
    return &images.color;
  foreign = true;
  return nullptr;
}

} // namespace

void describeWindow(ResidentImages &images, int width, int height) {
  const host::HostTable &host = *images.hot.host;
  Drawable &drawable = images.drawable;
  PixelImage &color = images.color;
  if (color.described != 0 && color.width == width && color.height == height)
    return;
  for (PixelImage *image : {&images.color, &images.depthStencil}) {
    // The host discards the pixels of a window that changed its size, and so does the layer.
    dropShadow(images, *image);
    image->described = images.objects.descriptions;
    image->base = 0;
    image->width = width;
    image->height = height;
    image->shadow = {};
    image->shadow.width = width;
    image->shadow.height = height;
  }
  if (width <= 0 || height <= 0 || drawable.kind == Drawable::Kind::None || !drawable.sameRead)
    return;
  GLboolean doubleBuffered = GL_FALSE;
  host.GetBooleanv(GL_DOUBLEBUFFER, &doubleBuffered);
  images.doubleBuffered = doubleBuffered != GL_FALSE;
  color.place = {Place::Kind::Window, 0, GLenum(images.doubleBuffered ? GL_BACK : GL_FRONT), 0};
  if (hostInteger(host, GL_SAMPLE_BUFFERS) != 0 || hostInteger(host, GL_STEREO) != 0)
    return;
  HostFormat format;
  format.red = hostInteger(host, GL_RED_BITS);
  format.green = hostInteger(host, GL_GREEN_BITS);
  format.blue = hostInteger(host, GL_BLUE_BITS);
  format.alpha = hostInteger(host, GL_ALPHA_BITS);
  GLint floats = 0;
  if (images.caps.has("GL_ARB_color_buffer_float"))
    floats = hostInteger(host, GL_RGBA_FLOAT_MODE_ARB);
  format.type = floats != 0 ? GL_FLOAT : GL_UNSIGNED_NORMALIZED;
  // Windows are shown as bytes. For components of 16 bits, hosts do not report reliably whether
  // they are floats.
  const bool known = formatOf(format, color.base, color.format);
  const bool bytes = known && color.format.layout == abi::Layout::U8x4;
  const bool packed = known && abi::isPacked(color.format.layout);
  if ((!bytes && !(packed && drawable.kind == Drawable::Kind::Pbuffer)) ||
      (drawable.kind == Drawable::Kind::Memory && drawable.memoryType != GL_UNSIGNED_BYTE)) {
    color.base = 0;
    return;
  }
  // use the order of components that presenting needs
  if (bytes && (drawable.kind != Drawable::Kind::Memory || drawable.memoryFormat == GL_BGRA))
    std::swap(color.format.swizzle[0], color.format.swizzle[2]);
  color.shadow.format = color.format;
  color.drawable = bytes && images.doubleBuffered ? &drawable : nullptr;

  PixelImage &depth = images.depthStencil;
  depth.place = {Place::Kind::Window, 0, GL_DEPTH, 0};
  HostFormat depthFormat;
  depthFormat.depth = hostInteger(host, GL_DEPTH_BITS);
  depthFormat.stencil = hostInteger(host, GL_STENCIL_BITS);
  depthFormat.type = GL_UNSIGNED_NORMALIZED;
  if (depthFormat.depth == 0 && depthFormat.stencil == 0)
    return;
  if (!formatOf(depthFormat, depth.base, depth.format))
    depth.base = 0;
  depth.shadow.format = depth.format;
  images.depthBits = depthFormat.depth;
  images.stencilBits = depthFormat.stencil;
}

namespace {

void describeDrawWindow(ResidentImages &images, Framebuffers &f) {
  const host::HostTable &host = *images.hot.host;
  bool foreign = images.color.base == 0;
  f.width = images.color.width;
  f.height = images.color.height;
  const GLint buffer = hostInteger(host, GL_DRAW_BUFFER);
  if (!foreign && buffer != GL_NONE)
    f.color[0] = windowBuffer(images, GLenum(buffer), foreign);
  const GLint count = std::min(images.caps.maxDrawBuffers, GLint(8));
  for (GLint i = 1; i < count; ++i)
    foreign = foreign || hostInteger(host, GLenum(GL_DRAW_BUFFER0 + i)) != GL_NONE;
  f.depthBits = images.depthBits;
  f.stencilBits = images.stencilBits;
  if (f.depthBits != 0 || f.stencilBits != 0) {
    f.depthStencil = images.depthStencil.base != 0 ? &images.depthStencil : nullptr;
    foreign = foreign || !f.depthStencil;
  }
  if (foreign)
    f.reason = "target";
}

void describeDrawObject(ResidentImages &images, Framebuffers &f) {
  const host::HostTable &host = *images.hot.host;
  f.reason = "target";
  if (host.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return;
  bool foreign = false;
  const GLint count = std::min(images.caps.maxDrawBuffers, GLint(8));
  f.width = f.height = 1 << 30;
  const auto limit = [&](const PixelImage *image) {
    if (!image)
      return;
    f.width = std::min(f.width, image->width);
    f.height = std::min(f.height, image->height);
  };
  for (GLint i = 0; i < count; ++i) {
    const auto buffer = GLenum(hostInteger(host, GLenum(GL_DRAW_BUFFER0 + i)));
    if (buffer == GL_NONE)
      continue;
    if (std::size_t(i) >= f.color.size())
      return;
    f.color[std::size_t(i)] =
        attached(images, GL_DRAW_FRAMEBUFFER, buffer, foreign, f.slice[std::size_t(i)]);
    limit(f.color[std::size_t(i)]);
  }
  int none = 0; // no 3D texture holds depths
  PixelImage *const depth =
      attached(images, GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, foreign, none);
  PixelImage *const stencil =
      attached(images, GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, foreign, none);
  // The rasterizer lacks separate stencil buffers, and stencil without depth.
  if (foreign || (stencil && stencil != depth))
    return;
  f.depthStencil = depth;
  limit(depth);
  if (depth) {
    f.depthBits = depth->format.layout == abi::Layout::Depth16           ? 16
                  : depth->format.layout == abi::Layout::Depth24Stencil8 ? 24
                                                                         : 32;
    f.stencilBits = depth->base == GL_DEPTH_STENCIL ? 8 : 0;
  }
  const auto isDepth = [](const PixelImage *image) {
    return image->base == GL_DEPTH_COMPONENT || image->base == GL_DEPTH_STENCIL;
  };
  for (std::size_t i = 0; i < f.color.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (f.color[i] && f.color[i] == f.color[j])
        return;
  for (const PixelImage *image : f.color)
    if (image && isDepth(image))
      return;
  if ((depth && !isDepth(depth)) || f.width == 1 << 30)
    return;
  f.reason = nullptr;
}

void describeRead(ResidentImages &images, Framebuffers &f) {
  const host::HostTable &host = *images.hot.host;
  const auto buffer = GLenum(hostInteger(host, GL_READ_BUFFER));
  bool foreign = false;
  f.readIsWindow = f.readName == 0;
  if (f.readIsWindow) {
    f.read = buffer == GL_NONE ? nullptr : windowBuffer(images, buffer, foreign);
    f.readDepth = images.depthStencil.base != 0 ? &images.depthStencil : nullptr;
    return;
  }
  if (host.CheckFramebufferStatus(GL_READ_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return;
  int slice = 0;
  if (buffer != GL_NONE)
    f.read = attached(images, GL_READ_FRAMEBUFFER, buffer, foreign, slice);
  // Readers take whole images, not slices.
  if (f.read && (readsAsOther(f.read->base) || f.read->depth != 1))
    f.read = nullptr;
  f.readDepth = attached(images, GL_READ_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, foreign, slice);
}

} // namespace

const Framebuffers &framebuffersOf(ResidentImages &images) {
  Framebuffers &f = images.framebuffers;
  ObjectImages &objects = images.objects;
  const bool sizeWanted = !images.sizeKnown && (f.drawName == 0 || f.readName == 0);
  if ((images.hot.dirty & dirty::kFramebuffer) == 0 && f.generation == objects.generation &&
      !sizeWanted) [[likely]]
    return f;
  images.hot.dirty &= ~dirty::kFramebuffer;
  HostErrorScope errors = errorScope(images);
  const host::HostTable &host = *images.hot.host;
  f = {};
  f.drawName = GLuint(hostInteger(host, GL_DRAW_FRAMEBUFFER_BINDING));
  f.readName = GLuint(hostInteger(host, GL_READ_FRAMEBUFFER_BINDING));
  if (f.drawName == 0 || f.readName == 0)
    refreshWindowSize(images);
  if (f.drawName == 0)
    describeDrawWindow(images, f);
  else
    describeDrawObject(images, f);
  describeRead(images, f);
  f.generation = objects.generation;
  objects.changed(); // kFramebuffer is clear now, so version() must report the change
  return f;
}

} // namespace arbiter::state
