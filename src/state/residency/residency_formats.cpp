// The formats of images in the host and the layer, and conversions between them.
#include "state/residency/residency_images.h"

namespace arbiter::state {

namespace {

using abi::From;
using abi::Layout;
using abi::Swizzle;

/// For each base format, the RGBA that sampling gives of the RGBA that was copied or uploaded
/// (table 3.15). C0 to C3 stand for R, G, B, A here.
struct Base {
  GLenum base;
  Swizzle picks;
  int components; ///< how many components a new shadow stores
  Swizzle stored; ///< RGBA in terms of the stored components
};
constexpr Base kBases[] = {
    {GL_RGBA, abi::kRgba, 4, abi::kRgba},
    {GL_RGB,
     {From::C0, From::C1, From::C2, From::One},
     4,
     {From::C0, From::C1, From::C2, From::One}},
    {GL_LUMINANCE,
     {From::C0, From::C0, From::C0, From::One},
     1,
     {From::C0, From::C0, From::C0, From::One}},
    {GL_LUMINANCE_ALPHA,
     {From::C0, From::C0, From::C0, From::C3},
     2,
     {From::C0, From::C0, From::C0, From::C1}},
    {GL_ALPHA,
     {From::Zero, From::Zero, From::Zero, From::C3},
     1,
     {From::Zero, From::Zero, From::Zero, From::C0}},
    {GL_INTENSITY,
     {From::C0, From::C0, From::C0, From::C0},
     1,
     {From::C0, From::C0, From::C0, From::C0}},
    {GL_RED,
     {From::C0, From::Zero, From::Zero, From::One},
     1,
     {From::C0, From::Zero, From::Zero, From::One}},
    {GL_RG,
     {From::C0, From::C1, From::Zero, From::One},
     2,
     {From::C0, From::C1, From::Zero, From::One}},
};

const Base *find(GLenum base) {
  for (const Base &row : kBases)
    if (row.base == base)
      return &row;
  return nullptr;
}

GLenum baseOf(const HostFormat &h) {
  if (h.depth != 0)
    return h.stencil != 0 ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT;
  if (h.intensity != 0)
    return GL_INTENSITY;
  if (h.luminance != 0)
    return h.alpha != 0 ? GL_LUMINANCE_ALPHA : GL_LUMINANCE;
  if (h.blue != 0)
    return h.alpha != 0 ? GL_RGBA : GL_RGB;
  if (h.green != 0)
    return GL_RG;
  if (h.red != 0)
    return GL_RED;
  return h.alpha != 0 ? GLenum(GL_ALPHA) : GLenum(0);
}

bool isS3tc(GLint internalFormat) {
  return (internalFormat >= GL_COMPRESSED_RGB_S3TC_DXT1_EXT &&
          internalFormat <= GL_COMPRESSED_RGBA_S3TC_DXT5_EXT) ||
         (internalFormat >= GL_COMPRESSED_SRGB_S3TC_DXT1_EXT &&
          internalFormat <= GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT);
}

/// Returns the layout of `components` values of `bits` and `type`. There is none of three
/// components; they use the layout of four.
Layout layoutOf(int components, GLint bits, GLint type) {
  const int index = components == 1 ? 0 : components == 2 ? 1 : 2;
  if (type == GL_UNSIGNED_NORMALIZED && bits == 8)
    return Layout(int(Layout::U8x1) + index);
  if (type == GL_UNSIGNED_NORMALIZED && bits == 16)
    return Layout(int(Layout::U16x1) + index);
  if (type == GL_FLOAT && bits == 16)
    return Layout(int(Layout::F16x1) + index);
  if (type == GL_FLOAT && bits == 32)
    return Layout(int(Layout::F32x1) + index);
  return Layout::None;
}

enum class Precision : std::uint8_t {
  Other,
  U8,
  U16,
  F16,
  F32,
  Bits565,
  Bits4444,
  Bits5551,
  Bits1010102
};
Precision precisionOf(Layout layout) {
  switch (layout) {
  case Layout::U8x1:
  case Layout::U8x2:
  case Layout::U8x4:
    return Precision::U8;
  case Layout::U16x1:
  case Layout::U16x2:
  case Layout::U16x4:
    return Precision::U16;
  case Layout::F16x1:
  case Layout::F16x2:
  case Layout::F16x4:
    return Precision::F16;
  case Layout::F32x1:
  case Layout::F32x2:
  case Layout::F32x4:
    return Precision::F32;
  case Layout::Bits565:
    return Precision::Bits565;
  case Layout::Bits4444:
    return Precision::Bits4444;
  case Layout::Bits5551:
    return Precision::Bits5551;
  case Layout::Bits1010102:
    return Precision::Bits1010102;
  case Layout::None:
  case Layout::Depth16:
  case Layout::Depth24Stencil8:
  case Layout::Depth32F:
  case Layout::Depth32:
    return Precision::Other;
  }
  return Precision::Other;
}

/// Returns the layout of texels that are packed into a word; None for other sizes.
Layout packedLayoutOf(const HostFormat &host) {
  struct Row {
    GLint red, green, blue, alpha;
    Layout layout;
  };
  static constexpr Row kRows[] = {
      {5, 6, 5, 0, Layout::Bits565},       {5, 5, 5, 0, Layout::Bits5551},
      {5, 5, 5, 1, Layout::Bits5551},      {4, 4, 4, 0, Layout::Bits4444},
      {4, 4, 4, 4, Layout::Bits4444},      {10, 10, 10, 0, Layout::Bits1010102},
      {10, 10, 10, 2, Layout::Bits1010102}};
  for (const Row &row : kRows)
    if (host.type == GL_UNSIGNED_NORMALIZED && host.red == row.red && host.green == row.green &&
        host.blue == row.blue && host.alpha == row.alpha)
      return row.layout;
  return Layout::None;
}

GLenum glType(Precision precision) {
  switch (precision) {
  case Precision::U8:
    return GL_UNSIGNED_BYTE;
  case Precision::U16:
    return GL_UNSIGNED_SHORT;
  case Precision::F16:
    return GL_HALF_FLOAT;
  case Precision::F32:
    return GL_FLOAT;
  case Precision::Bits565:
    return GL_UNSIGNED_SHORT_5_6_5;
  case Precision::Bits4444:
    return GL_UNSIGNED_SHORT_4_4_4_4;
  case Precision::Bits5551:
    return GL_UNSIGNED_SHORT_5_5_5_1;
  case Precision::Bits1010102:
    return GL_UNSIGNED_INT_2_10_10_10_REV;
  case Precision::Other:
    break;
  }
  return 0;
}

bool depthFormatOf(const HostFormat &host, abi::Format &format) {
  format.swizzle = {From::C0, From::C0, From::C0, From::One};
  if (host.stencil != 0 && host.stencil != 8)
    return false;
  if (host.type == GL_FLOAT)
    format.layout = host.depth == 32 && host.stencil == 0 ? Layout::Depth32F : Layout::None;
  else if (host.depth == 24)
    format.layout = Layout::Depth24Stencil8;
  else if (host.depth == 32)
    format.layout = host.stencil == 0 ? Layout::Depth32 : Layout::None;
  else
    format.layout = host.depth == 16 && host.stencil == 0 ? Layout::Depth16 : Layout::None;
  return format.layout != Layout::None;
}

} // namespace

bool isSrgb(GLint internalFormat) {
  switch (internalFormat) {
  case GL_SRGB:
  case GL_SRGB8:
  case GL_SRGB_ALPHA:
  case GL_SRGB8_ALPHA8:
  case GL_SLUMINANCE_ALPHA:
  case GL_SLUMINANCE8_ALPHA8:
  case GL_SLUMINANCE:
  case GL_SLUMINANCE8:
  case GL_COMPRESSED_SRGB:
  case GL_COMPRESSED_SRGB_ALPHA:
  case GL_COMPRESSED_SLUMINANCE:
  case GL_COMPRESSED_SLUMINANCE_ALPHA:
  case GL_COMPRESSED_SRGB_S3TC_DXT1_EXT:
  case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT:
  case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT:
  case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT:
    return true;
  default:
    return false;
  }
}

bool formatOf(const HostFormat &host, GLenum &base, abi::Format &format) {
  base = baseOf(host);
  if (base == GL_DEPTH_COMPONENT || base == GL_DEPTH_STENCIL)
    return depthFormatOf(host, format);
  const Base *const row = find(base);
  if (!row)
    return false;
  format.swizzle = row->stored;
  if (host.compressed) {
    if (!isS3tc(host.internalFormat))
      return false;
    format.layout = Layout::U8x4;
    return true;
  }
  format.layout = packedLayoutOf(host);
  if (format.layout != Layout::None)
    return true;
  const GLint sizes[] = {host.red,   host.green,     host.blue,
                         host.alpha, host.luminance, host.intensity};
  GLint bits = 0;
  for (const GLint size : sizes) {
    if (size == 0)
      continue;
    if (bits != 0 && size != bits)
      return false;
    bits = size;
  }
  format.layout = layoutOf(row->components, bits, host.type);
  return format.layout != Layout::None;
}

bool glFormatOf(const abi::Format &format, GLenum base, GlFormat &gl) {
  switch (format.layout) {
  case Layout::Depth16:
    gl = {GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT};
    return true;
  case Layout::Depth32F:
    gl = {GL_DEPTH_COMPONENT, GL_FLOAT};
    return true;
  case Layout::Depth32:
    gl = {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
    return true;
  case Layout::Depth24Stencil8:
    // A depth alone is read as 32 bits, whose upper 24 are where this layout has them.
    gl = base == GL_DEPTH_STENCIL ? GlFormat{GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8}
                                  : GlFormat{GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
    return true;
  default:
    break;
  }
  const Base *const row = find(base);
  const Precision precision = precisionOf(format.layout);
  if (!row || precision == Precision::Other)
    return false;
  gl.type = glType(precision);
  const int components = abi::componentsOf(format.layout);
  if (components < 4 && !abi::isPacked(format.layout)) {
    // A new shadow has just its own components in order. Luminance and intensity take their value
    // from RED.
    if (format.swizzle != row->stored || row->components != components)
      return false;
    if (components == 1)
      gl.format = base == GL_ALPHA ? GL_ALPHA : GL_RED;
    else
      gl.format = base == GL_RG ? GL_RG : GL_LUMINANCE_ALPHA;
    return true;
  }
  // With four components, those that the base format takes must be in RGBA or BGRA order.
  const auto fits = [&](const Swizzle &order) {
    for (int i = 0; i < 4; ++i) {
      const From pick = row->picks[std::size_t(i)];
      if (pick <= From::C3 && format.swizzle[std::size_t(i)] != order[std::size_t(pick)])
        return false;
    }
    return true;
  };
  if (fits(abi::kRgba))
    gl.format = format.layout == Layout::Bits565 ? GL_RGB : GL_RGBA;
  else if (!abi::isPacked(format.layout) && fits({From::C2, From::C1, From::C0, From::C3}))
    gl.format = GL_BGRA;
  else
    return false;
  return true;
}

bool viewAs(const abi::Format &from, GLenum base, const abi::Format &wanted, abi::Format &view) {
  const Base *const row = find(base);
  if (!row || precisionOf(from.layout) != precisionOf(wanted.layout) ||
      precisionOf(from.layout) == Precision::Other)
    return false;
  view.layout = from.layout;
  for (std::size_t i = 0; i < 4; ++i) {
    const From pick = row->picks[i];
    view.swizzle[i] = pick <= From::C3 ? from.swizzle[std::size_t(pick)] : pick;
  }
  return true;
}

bool writable(const abi::Format &format, const abi::Format &canonical) {
  if (format.layout != canonical.layout)
    return false;
  unsigned used = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if ((format.swizzle[i] <= From::C3) != (canonical.swizzle[i] <= From::C3))
      return false;
    if (format.swizzle[i] <= From::C3)
      used |= 1u << int(format.swizzle[i]);
  }
  unsigned canonicalUsed = 0;
  for (const From from : canonical.swizzle)
    if (from <= From::C3)
      canonicalUsed |= 1u << int(from);
  return used == canonicalUsed;
}

} // namespace arbiter::state
