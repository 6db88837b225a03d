#pragma once
#include <array>
#include <cstdint>

/// How DDS files hold their texels (Microsoft's "DDS programming guide").
namespace arbiter::scene {

/// Eight bits a component: red, green, blue, alpha.
using Rgba8 = std::array<std::uint8_t, 4>;

/// BC1 is DXT1, BC2 DXT3, BC3 DXT5: 4x4 texels in 8, 16 and 16 bytes. Plain texels are whole bytes,
/// of which each component has those of its mask; the lowest byte comes first.
enum class DdsKind : std::uint8_t { Bc1, Bc2, Bc3, Plain };

struct DdsFormat {
  DdsKind kind = DdsKind::Plain;
  unsigned bytes = 0;                      ///< of a texel; Plain
  std::array<std::uint32_t, 4> masks = {}; ///< of red, green, blue, alpha; Plain. 0: 0, but alpha 1
  bool isGrey = false;                     ///< red is green and blue too

  /// Of a level, in bytes.
  [[nodiscard]] std::uint64_t sizeOf(unsigned width, unsigned height) const {
    const std::uint64_t across = (width + 3) / 4, down = (height + 3) / 4;
    if (kind == DdsKind::Plain)
      return std::uint64_t(width) * height * bytes;
    return across * down * (kind == DdsKind::Bc1 ? 8 : 16);
  }
};

/// The 16 texels of a block of 8 or 16 bytes, row by row.
[[nodiscard]] std::array<Rgba8, 16> decodeBlock(DdsKind kind, const std::uint8_t *block);
/// One plain texel of format.bytes bytes.
[[nodiscard]] Rgba8 decodeTexel(const DdsFormat &format, const std::uint8_t *texel);

} // namespace arbiter::scene
