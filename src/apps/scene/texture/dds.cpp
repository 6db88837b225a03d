// Decodes DDS files: the header, then the levels of each face, the largest first.
#include <algorithm>
#include <bit>

#include "apps/scene/picture.h"
#include "apps/scene/texture/dds_format.h"
#include "apps/scene/texture/read_image.h"

namespace arbiter::scene {

namespace {

constexpr std::uint64_t kMaxTexels = std::uint64_t(1) << 26;
constexpr std::size_t kHeader = 128, kExtendedHeader = 148;

/// Bits of the header's fields.
constexpr std::uint32_t kHasAlpha = 0x1, kAlphaAlone = 0x2, kFourCc = 0x4, kRgb = 0x40,
                        kLuminance = 0x20000;
constexpr std::uint32_t kCubeMap = 0x200, kAllFaces = 0xFC00, kVolume = 0x200000;
constexpr std::uint32_t kExtendedCubeMap = 0x4;

constexpr std::uint32_t fourCc(const char (&text)[5]) {
  return std::uint32_t(text[0]) | std::uint32_t(text[1]) << 8 | std::uint32_t(text[2]) << 16 |
         std::uint32_t(text[3]) << 24;
}

class Decoder {
public:
  explicit Decoder(std::string_view bytes) : m_bytes(bytes) {}

  Result<std::vector<Image>, PictureError> run() {
    std::string reason = readHeader();
    if (reason.empty())
      reason = readFormat();
    if (reason.empty())
      reason = measure();
    if (!reason.empty())
      return PictureError{"this DDS file cannot be read: " + reason};
    std::vector<Image> images;
    for (unsigned face = 0; face < m_faces; ++face)
      images.push_back(readFace());
    return images;
  }

private:
  [[nodiscard]] std::uint32_t at(std::size_t place) const {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
      value |= std::uint32_t(std::uint8_t(m_bytes[place + i])) << 8 * i;
    return value;
  }

  std::string readHeader() {
    if (m_bytes.size() < kHeader || !m_bytes.starts_with("DDS ") || at(4) != 124 || at(76) != 32)
      return "it has no whole header";
    m_height = at(12);
    m_width = at(16);
    m_levels = std::max(at(28), 1u);
    if (m_width == 0 || m_height == 0 || m_width > kMaxSide || m_height > kMaxSide)
      return "a side is of 1 to 8192 texels, not " + std::to_string(m_width) + "x" +
             std::to_string(m_height);
    if (m_levels > unsigned(std::bit_width(std::max(m_width, m_height))))
      return std::to_string(m_levels) + " levels are more than the size has";
    const std::uint32_t caps = at(112);
    if (caps & kVolume)
      return "it is a 3D image";
    if ((caps & kCubeMap) && (caps & kAllFaces) != kAllFaces)
      return "faces of its cube map are missing";
    m_faces = caps & kCubeMap ? 6 : 1;
    m_data = kHeader;
    return {};
  }

  std::string readFormat() {
    const std::uint32_t flags = at(80), code = at(84);
    if (!(flags & kFourCc))
      return readMasks(flags);
    if (code == fourCc("DX10"))
      return readExtended();
    if (code == fourCc("DXT1"))
      m_format.kind = DdsKind::Bc1;
    else if (code == fourCc("DXT3"))
      m_format.kind = DdsKind::Bc2;
    else if (code == fourCc("DXT5"))
      m_format.kind = DdsKind::Bc3;
    else
      return "its format is none of DXT1, DXT3, DXT5 and plain RGBA";
    return {};
  }

  std::string readMasks(std::uint32_t flags) {
    if (!(flags & (kRgb | kLuminance | kAlphaAlone)))
      return "its texels are no colours";
    const std::uint32_t bits = at(88);
    if (bits == 0 || bits > 32 || bits % 8 != 0)
      return "texels have 8, 16, 24 or 32 bits";
    m_format.bytes = bits / 8;
    m_format.isGrey = flags & kLuminance;
    const bool alpha = flags & (kHasAlpha | kAlphaAlone);
    const bool colors = flags & (kRgb | kLuminance);
    m_format.masks = {colors ? at(92) : 0, at(96), at(100), alpha ? at(104) : 0};
    if (!(flags & kRgb))
      m_format.masks[1] = m_format.masks[2] = 0;
    for (const std::uint32_t mask : m_format.masks)
      if (mask != 0 && (mask >> std::countr_zero(mask)) > 255)
        return "components have at most 8 bits";
    return {};
  }

  /// Reads the header that newer tools write. Its formats are numbers of DXGI_FORMAT, with and
  /// without sRGB.
  std::string readExtended() {
    if (m_bytes.size() < kExtendedHeader)
      return "it has no whole header";
    m_data = kExtendedHeader;
    if (at(132) != 3 || at(140) != 1)
      return "it is no single 2D image";
    if (at(136) & kExtendedCubeMap)
      m_faces = 6;
    m_format.bytes = 4;
    switch (at(128)) {
    case 28: // R8G8B8A8
    case 29:
      m_format.masks = {0xFF, 0xFF00, 0xFF0000, 0xFF000000};
      return {};
    case 87: // B8G8R8A8
    case 91:
      m_format.masks = {0xFF0000, 0xFF00, 0xFF, 0xFF000000};
      return {};
    case 71:
    case 72:
      m_format.kind = DdsKind::Bc1;
      return {};
    case 74:
    case 75:
      m_format.kind = DdsKind::Bc2;
      return {};
    case 77:
    case 78:
      m_format.kind = DdsKind::Bc3;
      return {};
    default:
      return "its format (DXGI " + std::to_string(at(128)) +
             ") is none of BC1, BC2, BC3 and plain RGBA";
    }
  }

  /// Checks the sizes before any texel is read: all texels must be there, and not too many.
  std::string measure() const {
    std::uint64_t bytes = 0, texels = 0;
    for (unsigned level = 0; level < m_levels; ++level) {
      const auto [width, height] = sizeOf(level);
      bytes += m_format.sizeOf(width, height);
      texels += std::uint64_t(width) * height;
    }
    if (texels * m_faces > kMaxTexels)
      return "it has more than 2^26 texels";
    if (bytes * m_faces > m_bytes.size() - m_data)
      return "it ends too early: " + std::to_string(bytes * m_faces) + " bytes of texels, and " +
             std::to_string(m_bytes.size() - m_data) + " are there";
    return {};
  }

  [[nodiscard]] std::pair<unsigned, unsigned> sizeOf(unsigned level) const {
    return {std::max(m_width >> level, 1u), std::max(m_height >> level, 1u)};
  }

  Image readFace() {
    Image face = readLevel(0);
    for (unsigned level = 1; level < m_levels; ++level)
      face.smaller.push_back(readLevel(level));
    return face;
  }

  Image readLevel(unsigned level) {
    const auto [width, height] = sizeOf(level);
    Image image{int(width), int(height)};
    const auto *const data = reinterpret_cast<const std::uint8_t *>(m_bytes.data() + m_data);
    m_data += std::size_t(m_format.sizeOf(width, height));
    if (m_format.kind != DdsKind::Plain) {
      readBlocks(data, image);
      return image;
    }
    for (std::size_t i = 0; i < std::size_t(width) * height; ++i)
      put(image, i, decodeTexel(m_format, data + i * m_format.bytes));
    return image;
  }

  void readBlocks(const std::uint8_t *data, Image &image) const {
    for (int y = 0; y < image.height; y += 4)
      for (int x = 0; x < image.width; x += 4, data += m_format.kind == DdsKind::Bc1 ? 8 : 16) {
        const auto texels = decodeBlock(m_format.kind, data);
        for (int i = 0; i < 16; ++i)
          if (x + i % 4 < image.width && y + i / 4 < image.height)
            put(image, std::size_t(y + i / 4) * std::size_t(image.width) + std::size_t(x + i % 4),
                texels[std::size_t(i)]);
      }
  }

  static void put(Image &image, std::size_t texel, const Rgba8 &color) {
    std::copy(color.begin(), color.end(), image.texels.begin() + std::ptrdiff_t(4 * texel));
  }

  std::string_view m_bytes;
  std::size_t m_data = 0; ///< the offset of the next level
  unsigned m_width = 0, m_height = 0, m_levels = 1, m_faces = 1;
  DdsFormat m_format;
};

} // namespace

Result<std::vector<Image>, PictureError> decodeDds(std::string_view bytes) {
  return Decoder(bytes).run();
}

} // namespace arbiter::scene
