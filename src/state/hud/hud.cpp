#include "state/hud/hud.h"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/client_pixels/plain_transfer.h"
#include "state/control/host_pixels.h"
#include "state/control/tallies.h"
#include "state/core/texture_binding.h"
#include "state/hud/hud_text.h"
#include "state/identity/active_profile.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"
#include "state/report/refusals.h"
#include "state/share/share_group.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state::hud {

namespace {

using control::Picture;

/// Names that no application uses, like those of residency (residency_host.h).
constexpr GLuint kOurTexture = 0xFFFFFFFBu, kOurFramebuffer = 0xFFFFFFFBu;

/// Data from which a context's figures are computed.
struct Counters {
  std::array<std::uint64_t, kPathCount> draws{}; ///< at the end of the last frame
  control::FrameTimes times;
  std::string host;     ///< GL_RENDERER
  bool refused = false; ///< the host refused the figures, so they are not tried again
};

/// Counters by the context's serial number. Never freed: contexts may draw after static destructors
/// began.
struct AllCounters {
  std::mutex mutex;
  std::unordered_map<std::uint32_t, std::shared_ptr<Counters>> of;
};

std::shared_ptr<Counters> countersOf(const RasterContext &context) {
  constexpr std::size_t kMax = 64; // bounds the map, as contexts come and go
  static auto *const s_all = new AllCounters;
  const std::lock_guard lock(s_all->mutex);
  if (s_all->of.size() > kMax)
    s_all->of.clear();
  std::shared_ptr<Counters> &counters = s_all->of[context.serial];
  if (!counters)
    counters = std::make_shared<Counters>();
  return counters;
}

/// Returns the host's renderer, which is queried once.
const std::string &hostOf(const RasterContext &context, Counters &counters) {
  constexpr std::size_t kMax = 48; // letters
  if (counters.host.empty())
    if (const GLubyte *const name = context.host->GetString(GL_RENDERER))
      counters.host = std::string(reinterpret_cast<const char *>(name)).substr(0, kMax);
  return counters.host;
}

Figures figuresOf(RasterContext &context, Counters &counters) {
  Figures figures;
  figures.version = versionLine(activeProfile().name, activeProfile().description);
  figures.host = hostOf(context, counters);
  for (std::size_t age = counters.times.count(); age-- > 0;)
    figures.times.push_back(float(counters.times.of(age)));
  for (std::size_t i = 0; i < counters.draws.size(); ++i) {
    const std::uint64_t now = context.counters.draws[i],
                        before = std::exchange(counters.draws[i], now);
    if (now != before)
      figures.draws.push_back({pathName(Path(i)), now - before});
  }
  for (const std::shared_ptr<ProgramObject> &object : context.group->objects())
    if (const auto compiled = context.group->compiledOf(*object)) {
      ++figures.programs;
      figures.overNative += compiled->underNativeLimits ? 0u : 1u;
    }
  figures.refused = refusedTexts();
  return figures;
}

/// Returns the corner of the frame that the picture covers.
swrast::Rect placeOf(const Picture &picture, int frameWidth, int frameHeight) {
  const HudOptions &options = settings().hud;
  const int width = std::min(picture.width, frameWidth);
  const int height = std::min(picture.height, frameHeight);
  return {options.right ? frameWidth - width : 0, options.bottom ? 0 : frameHeight - height, width,
          height};
}

/// Copies the picture into an image of the rasterizer's. Returns false for formats other than four
/// bytes.
/// \param place inside the image
bool write(const swrast::Image &image, const Picture &picture, const swrast::Rect &place) {
  using abi::From;
  if (image.format.layout != abi::Layout::U8x4)
    return false;
  int stored[4] = {-1, -1, -1, -1}; // the byte of each component
  for (int c = 0; c < 4; ++c)
    if (const From from = image.format.swizzle[std::size_t(c)]; from <= From::C3)
      stored[c] = int(from);
  // A picture higher than the frame loses its lower rows.
  const int hidden = picture.height - place.height;
  for (int y = 0; y < place.height; ++y) {
    std::uint8_t *to = image.pixel(place.x, place.y + y);
    const std::uint8_t *from =
        picture.bytes.data() + std::size_t(hidden + y) * std::size_t(picture.width) * 4;
    for (int x = 0; x < place.width; ++x, to += 4, from += 4)
      for (int c = 0; c < 4; ++c)
        if (stored[c] >= 0)
          to[stored[c]] = from[c];
  }
  return true;
}

/// Uploads the picture to the layer's texture.
void upload(RasterContext &context, const Picture &picture) {
  const host::HostTable &host = *context.host;
  const PlainTransfer plain(context, PixelStore::Unpack);
  const TextureBinding bound(host, GL_TEXTURE_2D, kOurTexture, sharingOf(context));
  host.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, picture.bytes.data());
}

/// Makes the window's back buffer the draw buffer, while it lives.
class WindowDraw {
public:
  explicit WindowDraw(RasterContext &context) : m_context(context), m_host(*context.host) {
    if (context.caps.framebufferObjects) {
      m_framebuffer = hostInteger(m_host, GL_DRAW_FRAMEBUFFER_BINDING);
      if (m_framebuffer != 0)
        m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, 0);
    }
    m_buffer = hostInteger(m_host, GL_DRAW_BUFFER);
    m_host.DrawBuffer(hostInteger(m_host, GL_DOUBLEBUFFER) != 0 ? GL_BACK : GL_FRONT);
    context.dirty |= dirty::kFramebuffer;
  }
  ~WindowDraw() {
    m_host.DrawBuffer(GLenum(m_buffer));
    if (m_framebuffer != 0)
      m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, GLuint(m_framebuffer));
    m_context.dirty |= dirty::kFramebuffer;
  }
  WindowDraw(const WindowDraw &) = delete;
  WindowDraw &operator=(const WindowDraw &) = delete;

private:
  RasterContext &m_context;
  const host::HostTable &m_host;
  GLint m_framebuffer = 0, m_buffer = 0;
};

/// Makes the layer's texture the read buffer and blits plain, while it lives.
class BlitState {
public:
  explicit BlitState(RasterContext &context)
      : m_host(*context.host), m_read(hostInteger(m_host, GL_READ_FRAMEBUFFER_BINDING)),
        m_scissor(m_host.IsEnabled(GL_SCISSOR_TEST)),
        m_srgb(context.caps.srgbFramebuffer ? m_host.IsEnabled(GL_FRAMEBUFFER_SRGB)
                                            : GLboolean(GL_FALSE)) {
    m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, kOurFramebuffer);
    m_host.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                kOurTexture, 0);
    m_host.ReadBuffer(GL_COLOR_ATTACHMENT0);
    if (m_scissor)
      m_host.Disable(GL_SCISSOR_TEST);
    if (m_srgb)
      m_host.Disable(GL_FRAMEBUFFER_SRGB);
  }
  ~BlitState() {
    m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, GLuint(m_read));
    if (m_scissor)
      m_host.Enable(GL_SCISSOR_TEST);
    if (m_srgb)
      m_host.Enable(GL_FRAMEBUFFER_SRGB);
  }
  BlitState(const BlitState &) = delete;
  BlitState &operator=(const BlitState &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_read;
  GLboolean m_scissor, m_srgb;
};

/// Blits the picture to the window, which must be the draw buffer. Returns false if the host
/// refuses.
bool blit(RasterContext &context, const Picture &picture, const swrast::Rect &place) {
  if (!context.caps.framebufferObjects)
    return false;
  HostErrorScope errors(*context.host, context.errors.pending);
  upload(context, picture);
  {
    const BlitState state(context);
    context.host->BlitFramebuffer(0, picture.height - place.height, place.width, picture.height,
                                  place.x, place.y, place.x + place.width, place.y + place.height,
                                  GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  return !errors.failed();
}

/// Writes the picture into the shadow. Returns false if the shown pixels are the host's.
bool writeHere(RasterContext &context, const Picture &picture) {
  if (!context.software || !context.hostIsBehind)
    return false;
  Residency &residency = context.software->residency;
  const char *reason = nullptr;
  const DrawTargets *const targets = residency.describeTargets(reason);
  if (!targets || !targets->color[0] || !targets->isWindow)
    return false;
  const swrast::Rect place = placeOf(picture, targets->width, targets->height);
  return residency.acquireTargets(place, false, false) && write(*targets->color[0], picture, place);
}

/// True if the figures are shown now. Polls the key that toggles them, often enough for a short
/// press.
bool isShown() {
  constexpr std::int64_t kInterval = 20'000'000; // ns
  static std::atomic<std::int64_t> s_next = 0;
  static std::atomic<bool> s_shown = !settings().hud.hidden, s_wasDown = false;
  const auto keyIsDown = g_keyIsDown.load(std::memory_order_acquire);
  const std::int64_t now = control::nowNanoseconds();
  std::int64_t due = s_next.load(std::memory_order_relaxed);
  if (!keyIsDown || settings().hud.key.keysym == 0 || now < due ||
      !s_next.compare_exchange_strong(due, now + kInterval))
    return s_shown;
  const bool down = keyIsDown(settings().hud.key);
  if (down && !s_wasDown)
    s_shown = !s_shown;
  s_wasDown = down;
  return s_shown;
}

} // namespace

void draw(RasterContext &context) {
  const std::shared_ptr<Counters> counters = countersOf(context);
  if (context.passThrough || counters->refused)
    return;
  counters->times.frameEnded(control::nowNanoseconds());
  if (!isShown())
    return;
  int width = 0, height = 0;
  if (!control::drawableSize(context, width, height))
    return;
  const HudOptions options = fitted(settings().hud, height);
  const Figures figures = figuresOf(context, *counters);
  const Picture picture = pictureOf(
      linesOf(figures, options), options.has(HudPart::Graph) ? figures.times : std::vector<float>(),
      scaleOf(options, width, height));
  const WindowDraw window(context);
  if (writeHere(context, picture))
    return;
  if (context.software)
    context.software->residency.hostTakesTargets("figures in the frame");
  if (blit(context, picture, placeOf(picture, width, height)))
    return;
  counters->refused = true;
  logWarn("hud", "the host does not draw the figures (a multisampled window?)");
}

} // namespace arbiter::state::hud
