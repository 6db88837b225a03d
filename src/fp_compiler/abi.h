#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// The binary interface of generated code: plain data that the JIT back end and the rasterizer
/// share. The back end makes the functions, and the rasterizer calls them. No LLVM, no GL, no
/// containers.
///
/// Keys are plain bytes, compared and hashed as bytes. Make them with `Key key{}`, so that unused
/// parts are zero. A key's values are compiled into the code. Values that change without a new
/// function are in a Data struct.
namespace arbiter::abi {

/// How a texel or pixel is stored in memory, in the order of the bytes. A Swizzle says what the
/// components mean.
enum class Layout : std::uint8_t {
  None,
  U8x1, ///< 8-bit unsigned normalised
  U8x2,
  U8x4,
  U16x1, ///< 16-bit unsigned normalised
  U16x2,
  U16x4,
  F16x1, ///< half floats
  F16x2,
  F16x4,
  F32x1,
  F32x2,
  F32x4,
  Bits565,         ///< 16 bits, unsigned normalised: C0 the upper 5 bits, C1 6, C2 5
  Bits4444,        ///< 16 bits, from C0 in the upper bits down
  Bits5551,        ///< 16 bits, from C0 in the upper bits down
  Bits1010102,     ///< 32 bits, from C0 in the lower bits up
  Depth16,         ///< 16-bit unsigned normalised depth
  Depth24Stencil8, ///< 32 bits: depth in bits 8 to 31, stencil in bits 0 to 7
  Depth32F,        ///< a float in [0,1]
  Depth32,         ///< 32-bit unsigned normalised depth, made by depth32Of()
};
[[nodiscard]] constexpr int bytesOf(Layout layout) {
  constexpr int kBytes[] = {0, 1, 2, 4, 2, 4, 8, 2, 4, 8, 4, 8, 16, 2, 2, 2, 4, 2, 4, 4, 4};
  return kBytes[int(layout)];
}
/// Returns the stored components of a colour layout; 0 for other layouts.
[[nodiscard]] constexpr int componentsOf(Layout layout) {
  constexpr int kComponents[] = {0, 1, 2, 4, 1, 2, 4, 1, 2, 4, 1, 2, 4, 3, 4, 4, 4, 0, 0, 0, 0};
  return kComponents[int(layout)];
}
[[nodiscard]] constexpr bool isDepth(Layout layout) { return layout >= Layout::Depth16; }
/// Converts a depth in [0,1] to Depth32. A float has at most 24 significant bits, so hosts take 31
/// bits of its fraction and shift them up. A depth of 1 has all bits set.
[[nodiscard]] constexpr std::uint32_t depth32Of(float depth) {
  return depth < 1.0f ? std::uint32_t(depth * 0x1p31f) << 1 : ~0u;
}
/// Returns the steps between depths 0 and 1 that polygon offset counts in. Hosts use 24 bits for
/// float depth and without a depth buffer.
[[nodiscard]] constexpr double depthStepsOf(Layout layout) {
  return layout == Layout::Depth16   ? 65535.0
         : layout == Layout::Depth32 ? 4294967295.0
                                     : 16777215.0;
}
/// True if the components are parts of one word.
[[nodiscard]] constexpr bool isPacked(Layout layout) {
  return layout >= Layout::Bits565 && layout <= Layout::Bits1010102;
}
[[nodiscard]] constexpr bool isHalf(Layout layout) {
  return layout >= Layout::F16x1 && layout <= Layout::F16x4;
}
[[nodiscard]] constexpr bool isFloat(Layout layout) {
  return layout >= Layout::F16x1 && layout <= Layout::F32x4;
}
/// The position of a component in the word of a packed layout.
struct BitField {
  int shift = 0, bits = 0;
};
[[nodiscard]] constexpr BitField bitsOf(Layout layout, int component) {
  constexpr BitField kFields[4][4] = {{{11, 5}, {5, 6}, {0, 5}, {}},
                                      {{12, 4}, {8, 4}, {4, 4}, {0, 4}},
                                      {{11, 5}, {6, 5}, {1, 5}, {0, 1}},
                                      {{0, 10}, {10, 10}, {20, 10}, {30, 2}}};
  return kFields[int(layout) - int(Layout::Bits565)][component];
}

/// The source of a component of a texel's RGBA: a stored component or a constant.
enum class From : std::uint8_t { C0, C1, C2, C3, Zero, One };
/// The sources of R, G, B, A. BGRA8 is U8x4 with {C2, C1, C0, C3}, LUMINANCE8 is U8x1 with {C0, C0,
/// C0, One}, RGB8 is U8x4 with {C0, C1, C2, One}. For a colour buffer it says where each component
/// is written. A constant component is not written; its byte, if any, is 0xFF or 1.
using Swizzle = std::array<From, 4>;
inline constexpr Swizzle kRgba = {From::C0, From::C1, From::C2, From::C3};

struct Format {
  Layout layout = Layout::None;
  Swizzle swizzle = kRgba;
  /// A bit for each stored byte that is sRGB encoded and that a sampler decodes (OpenGL 2.1,
  /// 3.8.15). For layouts of bytes; 0 for a colour buffer.
  std::uint8_t srgb = 0;
  bool operator==(const Format &) const = default;
};
/// True for a 32-bit word whose four bytes are the components without decoding.
[[nodiscard]] constexpr bool isPlainWord(const Format &format) {
  return format.layout == Layout::U8x4 && format.srgb == 0;
}

inline constexpr int kMaxUnits = 16;       ///< texture image units that a program may sample
inline constexpr int kMaxColorTargets = 4; ///< draw buffers of a program
inline constexpr int kMaxLevels = 15;      ///< 16384 texels
inline constexpr int kMaxAnisotropy = 16;  ///< the most samples of a lookup
inline constexpr int kMaxInputs = 12;      ///< fragment attributes, of four components each

// --- Textures
// -------------------------------------------------------------------------------------

enum class Dimension : std::uint8_t { Tex1D, Tex2D, Tex3D, Cube, Rect };
enum class Wrap : std::uint8_t {
  Repeat,
  MirroredRepeat,
  Clamp, ///< GL_CLAMP: clamps to [0,1], so a linear filter reaches the border
  ClampToEdge,
  ClampToBorder,
  MirrorClamp, ///< ATI_texture_mirror_once, EXT_texture_mirror_clamp
  MirrorClampToEdge,
  MirrorClampToBorder,
};
enum class Filter : std::uint8_t { Nearest, Linear };
enum class MipFilter : std::uint8_t { None, Nearest, Linear };
/// Comparisons of depth, alpha and stencil, and TEXTURE_COMPARE_FUNC, in GL's order.
enum class Compare : std::uint8_t {
  Never,
  Less,
  Equal,
  LessEqual,
  Greater,
  NotEqual,
  GreaterEqual,
  Always
};

/// The state of a texture unit that code depends on. An incomplete texture is Layout::None, and
/// reads as (0, 0, 0, 1) (3.11.6).
struct SamplerKey {
  Dimension dimension = Dimension::Tex2D;
  Format format;
  std::array<Wrap, 3> wrap = {}; ///< s, t, r
  Filter magnify = Filter::Nearest;
  Filter minify = Filter::Nearest;
  MipFilter mip = MipFilter::None;
  std::uint8_t shadow = 0; ///< 1: compares z, also for 1D, with `compare`
  Compare compare = Compare::LessEqual;
  std::uint8_t powerOfTwo = 0;  ///< a bit for each axis whose size is one (Repeat is a mask)
  std::uint8_t hasBias = 0;     ///< 1: lodBias, minLod or maxLod differ from GL's initial values
  std::uint8_t anisotropic = 0; ///< 1: several samples along a long footprint; only with mipmaps
  bool operator==(const SamplerKey &) const = default;
};

/// One image: a level of a texture, or of a face of a cube map. `base` is texel (0, 0, 0). Strides
/// are in bytes, and negative if the image is stored upside down. Code may read 64 bytes before the
/// first and after the last row.
struct TextureLevel {
  const std::uint8_t *base = nullptr;
  std::int64_t rowStride = 0;
  std::int64_t sliceStride = 0;
  std::int32_t width = 0, height = 0, depth = 0; ///< in texels, without a border; 1 if unused
  std::int32_t reserved = 0;
};

struct TextureView {
  /// levels[level], counted from BASE_LEVEL; for a cube map levels[6 * level + face].
  const TextureLevel *levels = nullptr;
  std::int32_t levelCount = 0; ///< 1 without mipmaps
  float lodBias = 0;           ///< sum of the texture's and the unit's
  float minLod = -1000, maxLod = 1000;
  float maxAnisotropy = 1;   ///< greatest ratio of a footprint's axes: 1 to kMaxAnisotropy
  float borderColor[4] = {}; ///< as RGBA after the format (a LUMINANCE border is L, L, L, 1)
};

// --- Fragments
// ------------------------------------------------------------------------------------

enum class StencilOp : std::uint8_t {
  Keep,
  Zero,
  Replace,
  Increment,
  Decrement,
  Invert,
  IncrementWrap,
  DecrementWrap
};
enum class BlendFactor : std::uint8_t {
  Zero,
  One,
  SourceColor,
  OneMinusSourceColor,
  DestColor,
  OneMinusDestColor,
  SourceAlpha,
  OneMinusSourceAlpha,
  DestAlpha,
  OneMinusDestAlpha,
  ConstantColor,
  OneMinusConstantColor,
  ConstantAlpha,
  OneMinusConstantAlpha,
  SourceAlphaSaturate,
};
enum class BlendEquation : std::uint8_t { Add, Subtract, ReverseSubtract, Min, Max };
/// Logic operations in GL's order, from GL_CLEAR.
enum class LogicOp : std::uint8_t {
  Clear,
  And,
  AndReverse,
  Copy,
  AndInverted,
  Noop,
  Xor,
  Or,
  Nor,
  Equiv,
  Invert,
  OrReverse,
  CopyInverted,
  OrInverted,
  Nand,
  Set,
};

struct BlendKey {
  std::uint8_t enabled = 0;
  BlendFactor sourceColor = BlendFactor::One, destColor = BlendFactor::Zero;
  BlendFactor sourceAlpha = BlendFactor::One, destAlpha = BlendFactor::Zero;
  BlendEquation color = BlendEquation::Add, alpha = BlendEquation::Add;
  bool operator==(const BlendKey &) const = default;
};

/// A colour buffer, of any colour layout. With Layout::None the program's colour is dropped.
struct ColorTargetKey {
  Format format;
  std::uint8_t writeMask = 0xF; ///< bit 0 red .. bit 3 alpha
  BlendKey blend;
  bool operator==(const ColorTargetKey &) const = default;
};

struct StencilFaceKey {
  Compare compare = Compare::Always;
  StencilOp fail = StencilOp::Keep, depthFail = StencilOp::Keep, depthPass = StencilOp::Keep;
  bool operator==(const StencilFaceKey &) const = default;
};

struct DepthStencilKey {
  Layout layout = Layout::None; ///< None: both tests pass, nothing is written
  std::uint8_t depthTest = 0;
  std::uint8_t depthWrite = 0; ///< only with depthTest, as in GL
  Compare depthCompare = Compare::Less;
  std::uint8_t stencilTest = 0;
  StencilFaceKey front, back; ///< equal unless two-sided
  bool operator==(const DepthStencilKey &) const = default;
};

/// How an input varies over a primitive. Linear follows its plane. Even is Perspective with the
/// same w everywhere, so it uses the constant of inverseW.
enum class Interpolation : std::uint8_t { Flat, Linear, Even, Perspective };

/// The arrangement of pixels in the lanes of a vector.
enum class Lanes : std::uint8_t {
  Row,    ///< `lanes` pixels of one row; items are spans. Derivatives only if a coordinate is an
          ///< affine function of an input; for others the compiler refuses
  Quad,   ///< 2x2 quads: 4x4 pixels of 16 lanes, 4x2 of 8, 2x2 of 4; items are blocks
  Packed, ///< pixels, or quads of them, from anywhere in a tile, of several primitives
};

/// How much of its pixel a fragment covers (OpenGL 2.1, 3.12). It multiplies alpha after the
/// program and its options, before the alpha test. Line and Disc add an input after those of the
/// program: Perspective for a line, as on hosts, and Linear for a point.
/// Line: a smooth line. x and y are distances in pixels from the middle of the line, across and
/// along it. z and w are the distances from which the line no longer covers a pixel. Coverage is (z
/// - |x|) * (w - |y|), each clamped to [0,1].
/// Disc: a smooth point. (x, y) is the distance from its centre in radii. Beyond 1 there is no
/// fragment. Otherwise coverage is min(1, z * (1 - x * x - y * y)), as on hosts.
enum class Coverage : std::uint8_t { Whole, Line, Disc };

/// Everything besides the program that a fragment function is compiled for.
struct FragmentKey {
  Lanes lanes = Lanes::Row;
  std::uint8_t numerics = 0; ///< fp::Numerics: Host or Legacy (there is no code for Fp24)
  Compare alphaTest = Compare::Always;
  std::uint8_t logicOpEnabled = 0;
  LogicOp logicOp = LogicOp::Copy;
  std::uint8_t clampColors = 1; ///< clamps colours to [0,1] (fixed-point targets)
  Coverage coverage = Coverage::Whole;
  std::array<Interpolation, kMaxInputs> inputs = {}; ///< in the order of CompiledFragment::inputs
  DepthStencilKey depthStencil;
  std::array<ColorTargetKey, kMaxColorTargets> targets = {};
  std::array<SamplerKey, kMaxUnits> samplers = {}; ///< by unit; only those that are sampled
  bool operator==(const FragmentKey &) const = default;
};

/// A colour or depth buffer. `base` is pixel (0, 0) of the window, and may be outside of the
/// memory. The clip rectangle keeps accesses inside.
struct Target {
  std::uint8_t *base = nullptr;
  std::int64_t rowStride = 0; ///< bytes from a row to the one above it; negative if upside down
};

/// Data that all fragments of a draw share. `parameters` has a row for each of the program's
/// parameters, constants included.
struct FragmentData {
  const float (*parameters)[4] = nullptr;
  std::array<const TextureView *, kMaxUnits> textures = {};
  std::array<Target, kMaxColorTargets> targets = {};
  Target depthStencil;
  float alphaReference = 0;
  float blendColor[4] = {};
  std::uint8_t stencilReference[2] = {}; ///< front, back
  std::uint8_t stencilCompareMask[2] = {0xFF, 0xFF};
  std::uint8_t stencilWriteMask[2] = {0xFF, 0xFF};
  float windowHeight = 0;   ///< for fragment.position with the origin at the upper left
  std::int32_t originY = 0; ///< the row whose first pixel is the origin of all planes
  float depthMinimum = 0, depthMaximum = 1; ///< range that fragment depth is clamped to
};

/// The plane of an attribute's component. Its origin is the centre of pixel (0, originY).
struct Plane {
  float c = 0, dx = 0, dy = 0;
};
/// Returns the value at the centre of pixel (x, originY + y). Each product and its sum are rounded
/// once, as on hosts. About one in 2^28 is rounded twice, because the double is rounded too.
[[nodiscard]] inline float planeAt(const Plane &plane, std::int32_t x, std::int32_t y) {
  const auto along = float(double(plane.dx) * x + double(plane.c));
  return float(double(plane.dy) * y + double(along));
}

/// Window depth over a primitive: a plane and the polygon offset.
struct DepthPlane {
  float c = 0, dx = 0, dy = 0;
  float offset = 0;
};
/// Returns the depth at the centre of pixel (x, originY + y).
[[nodiscard]] inline float depthAt(const DepthPlane &z, std::int32_t x, std::int32_t y) {
  return planeAt({z.c, z.dx, z.dy}, x, y) + z.offset;
}

/// A triangle, or a line or point made of triangles, ready to be shaded. Even and Perspective
/// inputs hold attribute/w; code multiplies them by the reciprocal of the plane of 1/w.
struct Primitive {
  std::uint32_t backFacing = 0; ///< selects the stencil state
  DepthPlane z;
  Plane inverseW; ///< 1 / clip w
  Plane inputs[kMaxInputs][4];
};

/// Lanes::Row: pixels (x, y) to (x + count - 1, y).
struct Span {
  std::int16_t x = 0, y = 0;
  std::uint16_t count = 0, reserved = 0;
};
/// Lanes::Quad: a block of the variant's size. Its lower left pixel (x, y) is a multiple of that
/// size. Bit row * width + column of `mask` is set if a pixel is covered.
struct Block {
  std::int16_t x = 0, y = 0;
  std::uint16_t mask = 0, reserved = 0;
};
/// Lanes::Packed: one lane. If the code needs a level of detail or a derivative, every four are a
/// quad of one primitive: lower left, lower right, upper left, upper right.
struct Pixel {
  std::uint8_t x = 0, y = 0; ///< relative to the base of PrimitiveColumns
  std::uint8_t column = 0;   ///< the primitive's column
  std::uint8_t isHelper = 0; ///< kHelper or 0
  /// Marks a helper lane outside of the primitive. It is computed for the derivatives of its
  /// neighbours, and not written.
  static constexpr std::uint8_t kHelper = 0x80;
};

/// Lanes::Packed: primitives in columns, so that one vector can hold pixels of several. Row k has
/// the word at byte 4 * k of each Primitive, in the primitive's column.
struct PrimitiveColumns {
  /// One column for each lane of the widest vector, so that one instruction finds a lane's value in
  /// a row. A function uses only as many columns as it has lanes.
  static constexpr int kColumns = 16;
  static constexpr std::size_t kRows = sizeof(Primitive) / 4;
  static constexpr std::size_t rowOf(std::size_t offset) { return offset / 4; }

  std::int32_t baseX = 0, baseY = 0; ///< the pixel that is (0, 0) of Pixel
  alignas(64) std::uint32_t rows[kRows][kColumns];

  /// Sets a column.
  void set(int column, const Primitive &primitive) {
    std::uint32_t words[kRows];
    std::memcpy(words, &primitive, sizeof words);
    for (std::size_t row = 0; row < kRows; ++row)
      rows[row][column] = words[row];
  }
  [[nodiscard]] Primitive at(int column) const {
    std::uint32_t words[kRows];
    for (std::size_t row = 0; row < kRows; ++row)
      words[row] = rows[row][column];
    Primitive primitive;
    std::memcpy(&primitive, words, sizeof words);
    return primitive;
  }
};

/// Shades pixels of one primitive. `items` are `count` Spans or Blocks, by the key's lanes. Threads
/// may call it at the same time for separate pixels. It reads at most 64 bytes beyond rows of
/// textures, and writes no byte outside the given pixels.
using ShadeFunction = void (*)(const FragmentData *data, const Primitive *primitive,
                               const void *items, std::uint32_t count);
/// Shades pixels of Lanes::Packed. `count` is a multiple of the lane count. Only helper pixels may
/// occur twice.
using PackedShadeFunction = void (*)(const FragmentData *data, const PrimitiveColumns *primitives,
                                     const Pixel *pixels, std::uint32_t count);

// --- Vertices
// -------------------------------------------------------------------------------------

/// Everything besides the program that a vertex function is compiled for.
struct VertexKey {
  std::array<SamplerKey, kMaxUnits> samplers = {}; ///< by unit; only those that are sampled
  bool operator==(const VertexKey &) const = default;
};

/// Arrays of a vertex function, with one float a vertex. `inputs[4 * i + c]` points at component c
/// of the program's attribute i, `outputs[4 * i + c]` at that of its output i. Arrays hold a
/// multiple of 16 floats, aligned to 64 bytes. The function may write all of the last vector.
struct VertexData {
  const float (*parameters)[4] = nullptr;
  const float *const *inputs = nullptr;
  float *const *outputs = nullptr;
  /// kMaxUnits views; null if the program samples nothing.
  const TextureView *const *textures = nullptr;
};
using VertexFunction = void (*)(const VertexData *data, std::uint32_t count);

/// Returns a hash of the key's bytes.
template <typename Key> [[nodiscard]] std::size_t hashOf(const Key &key) {
  const auto *const bytes = reinterpret_cast<const unsigned char *>(&key);
  std::uint64_t hash = 1469598103934665603ull;
  for (std::size_t i = 0; i < sizeof(Key); ++i)
    hash = (hash ^ bytes[i]) * 1099511628211ull;
  return std::size_t(sizeof(std::size_t) < sizeof hash ? hash ^ hash >> 32 : hash);
}

} // namespace arbiter::abi
