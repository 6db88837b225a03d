#include "state/control/host_pixels.h"

#include <algorithm>
#include <array>
#include <utility>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

/// The most pixels of a picture of a frame or texture.
constexpr std::int64_t kMaxPixels = std::int64_t(64) << 20;

/// Shrinks a picture: each pixel is the mean of a square of `step` pixels a side.
Picture shrunk(const Picture &from, int step) {
  Picture to = {from.width / step, from.height / step, {}};
  to.width = std::max(to.width, 1);
  to.height = std::max(to.height, 1);
  to.bytes.resize(std::size_t(to.width) * std::size_t(to.height) * 4);
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        std::uint32_t sum = 0, count = 0;
        for (int v = y * step; v < std::min((y + 1) * step, from.height); ++v)
          for (int u = x * step; u < std::min((x + 1) * step, from.width); ++u, ++count)
            sum += from.bytes[(std::size_t(v) * std::size_t(from.width) + std::size_t(u)) * 4 + c];
        to.bytes[(std::size_t(y) * std::size_t(to.width) + std::size_t(x)) * 4 + c] =
            std::uint8_t((sum + count / 2) / std::max(count, 1u));
      }
  return to;
}

/// Gives the host all pixels.
void bringHostUpToDate(RasterContext &context) {
  if (context.software)
    context.software->residency.synchronise("a client of control");
}

/// Makes the window the read framebuffer, with its back buffer if there is one.
class WindowRead {
public:
  explicit WindowRead(RasterContext &context) : m_context(context), m_host(*context.host) {
    // GL_DOUBLEBUFFER is answered for the draw framebuffer.
    if (context.caps.framebufferObjects) {
      m_read = bind(GL_READ_FRAMEBUFFER, GL_READ_FRAMEBUFFER_BINDING);
      m_draw = bind(GL_DRAW_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER_BINDING);
    }
    m_buffer = hostInteger(m_host, GL_READ_BUFFER);
    m_host.ReadBuffer(hostInteger(m_host, GL_DOUBLEBUFFER) != 0 ? GL_BACK : GL_FRONT);
    context.dirty |= dirty::kFramebuffer;
  }
  ~WindowRead() {
    m_context.dirty |= dirty::kFramebuffer;
    m_host.ReadBuffer(GLenum(m_buffer));
    if (m_read != 0)
      m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, GLuint(m_read));
    if (m_draw != 0)
      m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, GLuint(m_draw));
  }
  WindowRead(const WindowRead &) = delete;
  WindowRead &operator=(const WindowRead &) = delete;

private:
  /// Binds the window's framebuffer. \returns what was bound
  GLint bind(GLenum target, GLenum query) {
    const GLint bound = hostInteger(m_host, query);
    if (bound != 0)
      m_host.BindFramebufferEXT(target, 0);
    return bound;
  }

  RasterContext &m_context;
  const host::HostTable &m_host;
  GLint m_read = 0, m_draw = 0, m_buffer = 0;
};

/// Makes a unit active, while it lives.
class ActiveUnit {
public:
  ActiveUnit(const host::HostTable &host, GLuint unit)
      : m_host(host), m_previous(hostInteger(host, GL_ACTIVE_TEXTURE)) {
    m_host.ActiveTexture(GL_TEXTURE0 + unit);
  }
  ~ActiveUnit() { m_host.ActiveTexture(GLenum(m_previous)); }
  ActiveUnit(const ActiveUnit &) = delete;
  ActiveUnit &operator=(const ActiveUnit &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_previous;
};

GLint levelParameter(const host::HostTable &host, GLenum image, GLint level, GLenum name) {
  GLint value = 0;
  host.GetTexLevelParameteriv(image, level, name, &value);
  return value;
}

} // namespace

Picture reduced(Picture picture, int maxWidth, int maxHeight) {
  const auto stepsFor = [](int size, int most) {
    return most <= 0 || size <= most ? 1 : (size + most - 1) / most;
  };
  const int step = std::max(stepsFor(picture.width, maxWidth), stepsFor(picture.height, maxHeight));
  return step == 1 ? std::move(picture) : shrunk(picture, step);
}

bool drawableSize(const RasterContext &context, int &width, int &height) {
  const Drawable &drawable = context.drawable;
  width = drawable.width;
  height = drawable.height;
  if (drawable.kind == Drawable::Kind::None)
    return false;
  return drawable.size ? drawable.size(drawable, width, height, false) : width > 0 && height > 0;
}

Picture readDrawable(RasterContext &context, const char *&why) {
  Picture picture;
  if (context.passThrough || !context.caps.compatibility) {
    why = "OpenGL ES and core profiles are passed through: there is no picture of them";
    return picture;
  }
  if (!drawableSize(context, picture.width, picture.height) ||
      std::int64_t(picture.width) * picture.height > kMaxPixels) {
    why = "the size of what is drawn to is not known";
    return {};
  }
  picture.bytes.resize(std::size_t(picture.width) * std::size_t(picture.height) * 4);
  const PlainTransfer plain(context, PixelStore::Pack);
  HostErrorScope errors(*context.host, context.errors.pending);
  {
    const WindowRead window(context);
    if (context.software &&
        context.software->residency.readPixels(0, 0, picture.width, picture.height, GL_RGBA,
                                               GL_UNSIGNED_BYTE, picture.bytes.data()))
      return picture;
    bringHostUpToDate(context);
    context.host->ReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                             picture.bytes.data());
  }
  if (!errors.failed())
    return picture;
  why = "the host refuses to read the frame";
  return {};
}

const std::array<TextureTarget, 5> &textureTargets() {
  static constexpr std::array<TextureTarget, 5> kTargets = {{
      {"1D", GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D, GL_TEXTURE_1D},
      {"2D", GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_2D},
      {"3D", GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_3D},
      {"CUBE", GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X},
      {"RECT", GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE, GL_TEXTURE_RECTANGLE},
  }};
  return kTargets;
}

std::vector<BoundTexture> boundTextures(RasterContext &context) {
  std::vector<BoundTexture> found;
  if (context.passThrough || !context.caps.compatibility)
    return found;
  const host::HostTable &host = *context.host;
  const HostErrorScope errors(host, context.errors.pending);
  const auto &targets = textureTargets();
  std::array<bool, 5> seenDefault{}; // by target
  for (GLint unit = 0; unit < context.caps.maxTextureImageUnits; ++unit) {
    const ActiveUnit active(host, GLuint(unit));
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (targets[i].target == GL_TEXTURE_RECTANGLE && !context.caps.textureRectangle)
        continue;
      BoundTexture texture = {hostInteger(host, targets[i].query), GLuint(unit), i};
      // Units without a texture share the target's default texture.
      if (texture.name == 0 && std::exchange(seenDefault[i], true))
        continue;
      texture.width = levelParameter(host, targets[i].image, 0, GL_TEXTURE_WIDTH);
      texture.height = levelParameter(host, targets[i].image, 0, GL_TEXTURE_HEIGHT);
      texture.depth = levelParameter(host, targets[i].image, 0, GL_TEXTURE_DEPTH);
      texture.format = levelParameter(host, targets[i].image, 0, GL_TEXTURE_INTERNAL_FORMAT);
      if (texture.name != 0 || texture.width != 0)
        found.push_back(texture);
    }
  }
  return found;
}

/// Spreads luminance and intensity to all colours, and intensity to alpha, as samplers do (3.9.1).
/// GetTexImage returns both as red alone (6.1.4).
void spreadGrey(const host::HostTable &host, GLenum image, Picture &picture) {
  const bool intensity = levelParameter(host, image, 0, GL_TEXTURE_INTENSITY_SIZE) != 0;
  if (!intensity && levelParameter(host, image, 0, GL_TEXTURE_LUMINANCE_SIZE) == 0)
    return;
  for (std::size_t i = 0; i + 3 < picture.bytes.size(); i += 4) {
    picture.bytes[i + 1] = picture.bytes[i + 2] = picture.bytes[i];
    if (intensity)
      picture.bytes[i + 3] = picture.bytes[i];
  }
}

Picture readTexture(RasterContext &context, const BoundTexture &texture, const char *&why) {
  const std::int64_t pixels =
      std::int64_t(texture.width) * std::max(texture.height, 1) * std::max(texture.depth, 1);
  if (pixels <= 0 || pixels > kMaxPixels) {
    why = pixels <= 0 ? "the texture has no image" : "the texture is too large";
    return {};
  }
  bringHostUpToDate(context);
  const host::HostTable &host = *context.host;
  const PlainTransfer plain(context, PixelStore::Pack);
  HostErrorScope errors(host, context.errors.pending);
  Picture picture = {texture.width, std::max(texture.height, 1), {}};
  picture.bytes.resize(std::size_t(pixels) * 4);
  {
    const ActiveUnit active(host, texture.unit);
    const GLenum image = textureTargets()[texture.target].image;
    host.GetTexImage(image, 0, GL_RGBA, GL_UNSIGNED_BYTE, picture.bytes.data());
    picture.bytes.resize(std::size_t(picture.width) * std::size_t(picture.height) * 4);
    spreadGrey(host, image, picture);
  }
  if (!errors.failed())
    return picture;
  why = "its format holds no colours";
  return {};
}

bool writeTexture(RasterContext &context, const BoundTexture &texture, const Picture &picture,
                  const char *&why) {
  const TextureTarget &target = textureTargets()[texture.target];
  if (target.target != GL_TEXTURE_2D && target.target != GL_TEXTURE_RECTANGLE) {
    why = "only two-dimensional textures can be replaced";
    return false;
  }
  if (picture.width != texture.width || picture.height != texture.height) {
    why = "the image has another size than the texture";
    return false;
  }
  const host::HostTable &host = *context.host;
  const ActiveUnit active(host, texture.unit);
  if (context.software) // the host's copy is the valid one from here on
    context.software->residency.textureRedefined(target.target);
  context.dirty |= dirty::kTextureBindings;
  const PlainTransfer plain(context, PixelStore::Unpack);
  HostErrorScope errors(host, context.errors.pending);
  Picture level = picture;
  for (GLint i = 0;; ++i) {
    host.TexSubImage2D(target.target, i, 0, 0, level.width, level.height, GL_RGBA, GL_UNSIGNED_BYTE,
                       level.bytes.data());
    const bool last = (level.width == 1 && level.height == 1) ||
                      target.target == GL_TEXTURE_RECTANGLE ||
                      levelParameter(host, target.target, i + 1, GL_TEXTURE_WIDTH) !=
                          std::max(level.width / 2, 1);
    if (last)
      break;
    level = shrunk(level, 2);
  }
  if (!errors.failed())
    return true;
  why = "the host refuses the image for the texture's format";
  return false;
}

} // namespace arbiter::state::control
