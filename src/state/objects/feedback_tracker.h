#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "util/record/counter.h"

/// Texture feedback: copies of a colour buffer to a texture level (glReadBuffer, then
/// glCopyTexSubImage), the multipass technique of the time. Tracks which buffer became which level,
/// and when, so that copies can be avoided later. No GL calls here, and no GL types.
namespace arbiter::state {

/// A colour buffer: the framebuffer object (0: the window) and the enum of glReadBuffer.
struct ColorBuffer {
  std::uint32_t framebuffer = 0;
  std::uint32_t buffer = 0;
  bool operator==(const ColorBuffer &) const = default;
};

/// A texture level; `target` is the image target, such as a face of a cube map.
struct TextureLevel {
  std::uint32_t texture = 0;
  std::uint32_t target = 0;
  std::int32_t level = 0;
  bool operator==(const TextureLevel &) const = default;
};

/// The region of a copy, in texels and window pixels, y up.
struct CopyRegion {
  std::int32_t destX = 0, destY = 0, destZ = 0;
  std::int32_t x = 0, y = 0;
  std::int32_t width = 0, height = 0;
  bool operator==(const CopyRegion &) const = default;
};

enum class CopyKind : std::uint8_t { Image1D, Image2D, SubImage1D, SubImage2D, SubImage3D };
inline constexpr int kCopyKindCount = 5;
[[nodiscard]] const char *copyKindName(CopyKind kind);

struct Copy {
  CopyKind kind = CopyKind::Image2D;
  ColorBuffer source;
  CopyRegion region;
  std::uint64_t frame = 0;    ///< of the copying context
  std::uint64_t sequence = 0; ///< 1 for the context's first copy
};

/// The copies of one context. Memory is bounded: levels beyond kMaxLevels are counted, not kept.
class FeedbackTracker {
public:
  static constexpr std::size_t kMaxLevels = 4096;

  struct Totals {
    Counter copies;
    Counter pixels;
  };

  void record(const TextureLevel &to, CopyKind kind, const ColorBuffer &from,
              const CopyRegion &region, std::uint64_t frame);
  /// Returns the last copy to that level, or null. Other commands may have overwritten it since.
  [[nodiscard]] const Copy *lastCopy(const TextureLevel &level) const;
  [[nodiscard]] const Totals &totals(CopyKind kind) const { return m_totals[std::size_t(kind)]; }
  [[nodiscard]] std::uint64_t copies() const { return m_sequence; }
  [[nodiscard]] std::size_t levels() const { return m_levels ? m_levels->size() : 0; }
  /// Forgets a texture that is deleted, or whose name is reused.
  void forget(std::uint32_t texture);

private:
  struct Hash {
    std::size_t operator()(const TextureLevel &level) const;
  };
  using Map = std::unordered_map<TextureLevel, Copy, Hash>;

  std::array<Totals, kCopyKindCount> m_totals{};
  std::uint64_t m_sequence = 0;
  std::unique_ptr<Map> m_levels; ///< null before the first copy: most contexts have none
};

} // namespace arbiter::state
