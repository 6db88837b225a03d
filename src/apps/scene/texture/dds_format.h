#pragma once
#include <array>
#include <cstdint>

/// The formats of texels in DDS files (Microsoft's "DDS programming guide").
namespace arbiter::scene {

/// A texel with eight bits a component: red, green, blue, alpha.
using Rgba8 = std::array<std::uint8_t, 4>;

/// The kind of texel data. BC1 is DXT1, BC2 DXT3, BC3 DXT5: 4x4 texels in 8, 16 and 16 bytes. Plain
/// texels are whole bytes, the lowest first, and a mask selects the bits of each component.
enum class DdsKind : std::uint8_t { Bc1, Bc2, Bc3, Plain };

struct DdsFormat {
  DdsKind kind = DdsKind::Plain;
  unsigned bytes = 0; ///< of a Plain texel
  /// Plain: of red, green, blue, alpha. A mask of 0 means 0, but 1 for alpha
  std::array<std::uint32_t, 4> masks = {};
  bool isGrey = false; ///< green and blue equal red

  /// Returns the size of a level in bytes.
  [[nodiscard]] std::uint64_t sizeOf(unsigned width, unsigned height) const {
    const std::uint64_t across = (width + 3) / 4, down = (height + 3) / 4;
    if (kind == DdsKind::Plain)
      return std::uint64_t(width) * height * bytes;
    return across * down * (kind == DdsKind::Bc1 ? 8 : 16);
  }
};

/// Decodes the 16 texels of a block of 8 or 16 bytes, row by row.
[[nodiscard]] std::array<Rgba8, 16> decodeBlock(DdsKind kind, const std::uint8_t *block);
/// Decodes a plain texel of format.bytes bytes.
[[nodiscard]] Rgba8 decodeTexel(const DdsFormat &format, const std::uint8_t *texel);

} // namespace arbiter::scene
