// Finds the size of the window's buffers. The host's buffers decide, whatever the window system
// reports: the host draws between draws of the rasterizer and clips by its own buffers, and a read
// outside them returns nothing. A software host adopts a new size only at the first pixel command
// after it was bound or has presented a frame. It does not know of frames that the layer presents.
#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "state/residency/residency_host.h"
#include "state/residency/window_frames.h"

namespace arbiter::state {

namespace {

struct Size {
  int width = 0, height = 0;
  bool operator==(const Size &) const = default;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// Reads the window's colours, only to find out where there are pixels.
class Probe {
public:
  Probe(ResidentImages &images)
      : m_host(*images.hot.host), m_framebuffers(images, 0, 0),
        m_pixels(images, PlainPixels::Way::Pack, 0, 0) {
    m_host.GetIntegerv(GL_READ_BUFFER, &m_buffer);
    GLboolean doubleBuffered = GL_FALSE;
    m_host.GetBooleanv(GL_DOUBLEBUFFER, &doubleBuffered);
    if (m_buffer == GL_NONE)
      m_host.ReadBuffer(doubleBuffered ? GL_BACK : GL_FRONT);
    // Hosts clip a command before they update their buffers, so one read comes first.
    std::uint32_t first = 0;
    read({0, 0, 1, 1}, {&first, 1});
  }
  ~Probe() {
    if (m_buffer == GL_NONE)
      m_host.ReadBuffer(GL_NONE);
  }
  Probe(const Probe &) = delete;
  Probe &operator=(const Probe &) = delete;

  /// True if the buffers have exactly this size.
  [[nodiscard]] bool has(Size size) const {
    if (size.empty())
      return false;
    // Read the last pixel, which exists, and three beyond it.
    std::array<std::uint32_t, 4> zeros, ones;
    readTwice({size.width - 1, size.height - 1, 2, 2}, zeros, ones);
    return zeros[0] == ones[0] && zeros[1] != ones[1] && zeros[2] != ones[2];
  }
  [[nodiscard]] Size measure() const {
    std::vector<std::uint32_t> zeros(kLongest), ones(kLongest);
    const auto count = [&](const swrast::Rect &line) {
      readTwice(line, zeros, ones);
      const auto end = std::mismatch(zeros.begin(), zeros.end(), ones.begin()).first;
      return int(end - zeros.begin());
    };
    return {count({0, 0, kLongest, 1}), count({0, 0, 1, kLongest})};
  }

private:
  static constexpr GLsizei kLongest = 16384;

  void read(const swrast::Rect &from, std::span<std::uint32_t> to) const {
    m_host.ReadPixels(from.x, from.y, from.width, from.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      to.data());
  }
  /// Reads into both spans. They differ where there is no pixel.
  void readTwice(const swrast::Rect &from, std::span<std::uint32_t> zeros,
                 std::span<std::uint32_t> ones) const {
    std::fill(zeros.begin(), zeros.end(), 0u);
    std::fill(ones.begin(), ones.end(), ~0u);
    read(from, zeros);
    read(from, ones);
  }

  const host::HostTable &m_host;
  const FramebufferBinding m_framebuffers;
  const PlainPixels m_pixels;
  GLint m_buffer = GL_NONE;
};

Size told(const Drawable &drawable, bool sure) {
  Size size;
  return drawable.size(drawable, size.width, size.height, sure) ? size : Size{};
}

/// Makes the host look at the window's size again. Its back buffer gets the shown pixels first.
void refreshHost(ResidentImages &images) {
  PixelImage &color = images.color;
  if (color.valid == Valid::Shadow) {
    upload(images, color);
    setValid(images, color, Valid::Both);
  }
  windowFrames().swapHost(images.drawable);
}

Size sizeOf(ResidentImages &images) {
  Drawable &drawable = images.drawable;
  const bool sure = std::exchange(images.sizeSure, false);
  if (!drawable.size)
    return {drawable.width, drawable.height};
  if (drawable.kind == Drawable::Kind::Pbuffer) // its size never changes
    return told(drawable, sure);
  const Size known =
      images.color.described != 0 ? Size{images.color.width, images.color.height} : Size{};
  const bool missed = drawable.show && windowFrames().hostMissed(drawable, true);
  if (missed) {
    const Size now = told(drawable, sure);
    // The host would have found no change either.
    if (now == known)
      return now;
    if (now.empty() || (known.empty() && Probe(images).has(now)))
      return now;
    refreshHost(images);
  }
  const Probe probe(images);
  if (!missed && probe.has(known))
    return known;
  const Size now = told(drawable, true);
  return now.empty() || probe.has(now) ? now : probe.measure();
}

} // namespace

bool hostMissedFrames(const ResidentImages &images) {
  return !images.sizeKnown && images.drawable.show &&
         windowFrames().hostMissed(images.drawable, false);
}

void Residency::hostSwaps() { forgetSize(*m_images); }

void refreshWindowSize(ResidentImages &images) {
  if (images.sizeKnown && images.color.described != 0)
    return;
  const host::HostTable &host = *images.hot.host;
  HostErrorScope errors = errorScope(images);
  // These queries are answered for the bound draw framebuffer.
  GLint bound = 0;
  host.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  if (bound != 0)
    host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, 0);
  const Drawable &drawable = images.drawable;
  Size size;
  if (drawable.kind != Drawable::Kind::None && drawable.sameRead)
    size = sizeOf(images);
  images.sizeKnown = true;
  if (size != Size{images.color.width, images.color.height})
    images.objects.redefined();
  describeWindow(images, size.width, size.height);
  if (bound != 0)
    host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, GLuint(bound));
}

} // namespace arbiter::state
