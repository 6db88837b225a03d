#include "state/control/probe_target.h"

#include <algorithm>

#include "state/capabilities/host_integer.h"
#include "state/control/host_pixels.h"
#include "state/core/host_errors.h"
#include "state/core/texture_binding.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

constexpr std::size_t kDepth = ProbeTarget::kMaxColors; ///< index of the depth texture

/// The depth formats that copies are tried with. Framebuffer objects often have no stencil, windows
/// mostly have.
constexpr GLenum kDepthFormats[] = {GL_DEPTH24_STENCIL8,  GL_DEPTH_COMPONENT24,
                                    GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT16,
                                    GL_DEPTH32F_STENCIL8, GL_DEPTH_COMPONENT32F};

bool stencilIsIn(GLenum format) {
  return format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
}

/// A component layout and type that go with an internal format, for an image without contents.
struct Layout {
  GLenum components, type;
};
Layout layoutOf(GLenum format) {
  switch (format) {
  case GL_RGBA32F:
    return {GL_RGBA, GL_FLOAT};
  case GL_DEPTH24_STENCIL8:
    return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
  case GL_DEPTH32F_STENCIL8:
    return {GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
  default:
    return {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
  }
}

} // namespace

/// Makes names that differ from those of the figures in the frame (state/hud).
ProbeTarget::ProbeTarget(RasterContext &context, const host::HostTable &host, Use use)
    : m_context(context), m_host(host),
      m_framebuffer(use == Use::Values ? 0xFFFFFFF9u : 0xFFFFFFF8u),
      m_firstTexture(use == Use::Values ? 0xFFFFFFF0u : 0xFFFFFFE0u) {}

ProbeTarget::~ProbeTarget() {
  if (!m_made)
    return;
  const HostErrorScope errors(m_host, m_context.errors.pending);
  m_host.DeleteFramebuffers(1, &m_framebuffer);
  for (std::size_t i = 0; i <= kDepth; ++i) {
    const GLuint name = m_firstTexture + GLuint(i);
    m_host.DeleteTextures(1, &name);
  }
}

bool ProbeTarget::hasStencil() const { return stencilIsIn(m_depthFormat); }

/// Defines an image without contents for one of the layer's names. Bindings stay unchanged.
void ProbeTarget::image(std::size_t index, int width, int height, GLenum format) {
  const TextureBinding bound(m_host, GL_TEXTURE_2D, m_firstTexture + GLuint(index),
                             sharingOf(m_context));
  const Layout layout = layoutOf(format);
  m_host.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), width, height, 0, layout.components,
                    layout.type, nullptr);
  m_host.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
}

bool ProbeTarget::attach(std::size_t colors, const Region &region, GLenum depthFormat) {
  m_made = true;
  const int width = region.x + region.width, height = region.y + region.height;
  const PlainTransfer plain(m_context, PixelStore::Unpack);
  for (std::size_t i = 0; i < colors; ++i)
    image(i, width, height, GL_RGBA32F);
  if (depthFormat != 0)
    image(kDepth, width, height, depthFormat);
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, m_framebuffer);
  std::array<GLenum, kMaxColors> buffers{};
  for (std::size_t i = 0; i < kMaxColors; ++i) {
    const bool used = i < colors;
    buffers[i] = used ? GLenum(GL_COLOR_ATTACHMENT0 + i) : GLenum(GL_NONE);
    m_host.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GLenum(GL_COLOR_ATTACHMENT0 + i),
                                GL_TEXTURE_2D, used ? m_firstTexture + GLuint(i) : 0, 0);
  }
  const GLuint depth = depthFormat != 0 ? m_firstTexture + GLuint(kDepth) : 0;
  m_host.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  m_host.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                              stencilIsIn(depthFormat) ? depth : 0, 0);
  m_host.DrawBuffers(GLsizei(std::max<std::size_t>(colors, 1)), buffers.data());
  return m_host.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void ProbeTarget::copyDepths(GLuint source, const Region &part) {
  const GLint x = part.x, y = part.y, right = x + part.width, top = y + part.height;
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, source);
  m_host.BlitFramebuffer(
      x, y, right, top, x, y, right, top,
      hasStencil() ? GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT : GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

std::string ProbeTarget::attachDepthsOf(GLuint source, std::size_t colors, const Region &region) {
  const auto copied = [&](GLenum format) {
    HostErrorScope errors(m_host, m_context.errors.pending);
    m_depthFormat = format;
    if (!attach(colors, region, format))
      return false;
    copyDepths(source, region);
    return !errors.failed();
  };
  // Try the format of the last draw first.
  if (m_depthFormat != 0 && copied(m_depthFormat))
    return {};
  if (std::any_of(std::begin(kDepthFormats), std::end(kDepthFormats), copied))
    return {};
  m_depthFormat = 0;
  return "the depths that the draw finds cannot be copied (are they multisampled?)";
}

HasDepths::HasDepths(const host::HostTable &host)
    : depth(hostInteger(host, GL_DEPTH_BITS) != 0),
      stencil(hostInteger(host, GL_STENCIL_BITS) != 0) {}

namespace {

bool renderbufferSize(const host::HostTable &host, GLuint name, int &width, int &height) {
  const GLint before = hostInteger(host, GL_RENDERBUFFER_BINDING);
  host.BindRenderbuffer(GL_RENDERBUFFER, name);
  host.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &width);
  host.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &height);
  host.BindRenderbuffer(GL_RENDERBUFFER, GLuint(before));
  return width > 0 && height > 0;
}

/// Gets a texture's size. GL does not report a name's target, but the name can only be bound to
/// that one.
bool textureSize(RasterContext &context, const host::HostTable &host, GLuint name, GLint level,
                 int &width, int &height) {
  for (const TextureTarget &target : textureTargets()) {
    if (target.target == GL_TEXTURE_RECTANGLE && !context.caps.textureRectangle)
      continue;
    HostErrorScope errors(host, context.errors.pending);
    const TextureBinding bound(host, target.target, name, sharingOf(context));
    if (errors.failed())
      continue;
    host.GetTexLevelParameteriv(target.image, level, GL_TEXTURE_WIDTH, &width);
    host.GetTexLevelParameteriv(target.image, level, GL_TEXTURE_HEIGHT, &height);
    return width > 0 && height > 0;
  }
  return false;
}

} // namespace

bool framebufferSize(RasterContext &context, const host::HostTable &host, int &width, int &height) {
  const HostErrorScope errors(host, context.errors.pending);
  for (const GLenum place : {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_COLOR_ATTACHMENT1}) {
    const auto ask = [&](GLenum name) {
      GLint value = 0;
      host.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, place, name, &value);
      return value;
    };
    const GLint type = ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (type != GL_RENDERBUFFER && type != GL_TEXTURE)
      continue;
    const auto name = GLuint(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    if (type == GL_RENDERBUFFER
            ? renderbufferSize(host, name, width, height)
            : textureSize(context, host, name, ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL), width,
                          height))
      return true;
  }
  return false;
}

TargetScope::TargetScope(const host::HostTable &host)
    : m_host(host), m_read(hostInteger(host, GL_READ_FRAMEBUFFER_BINDING)),
      m_draw(hostInteger(host, GL_DRAW_FRAMEBUFFER_BINDING)) {
  host.PushAttrib(GL_ALL_ATTRIB_BITS);
}

TargetScope::~TargetScope() {
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, GLuint(m_draw));
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, GLuint(m_read));
  m_host.PopAttrib();
}

bool limitTo(const host::HostTable &host, const Region &region) {
  GLint box[4] = {region.x, region.y, region.x + region.width, region.y + region.height};
  if (host.IsEnabled(GL_SCISSOR_TEST)) {
    GLint theirs[4] = {};
    host.GetIntegerv(GL_SCISSOR_BOX, theirs);
    for (std::size_t i = 0; i < 2; ++i) {
      box[i] = std::max(box[i], theirs[i]);
      box[i + 2] = std::min(box[i + 2], theirs[i] + theirs[i + 2]);
    }
  }
  host.Enable(GL_SCISSOR_TEST);
  host.Scissor(box[0], box[1], std::max(box[2] - box[0], 0), std::max(box[3] - box[1], 0));
  return box[2] > box[0] && box[3] > box[1];
}

} // namespace arbiter::state::control
