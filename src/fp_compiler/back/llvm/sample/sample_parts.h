#pragma once
#include <functional>

#include "fp_compiler/back/llvm/code/code.h"

/// The parts that sample() is made of: where texels lie (wrap), how they are read (fetch), what
/// their bits mean (decode), and how several become one (filter).
namespace arbiter::fp::llvm_back {

/// A load of what stays the same as long as the function runs, so that LLVM moves it out of loops
/// in spite of the stores to colour buffers.
[[nodiscard]] Value *constantField(Code &code, llvm::Type *type, Value *pointer,
                                   std::size_t offset);

/// One i1 for all lanes: whether any of \p mask (an i1 a lane) is set.
[[nodiscard]] Value *anyLane(Code &code, Value *mask);
/// One i1 for all lanes: whether every one of \p mask is set.
[[nodiscard]] Value *allLanes(Code &code, Value *mask);

/// One image as code sees it: scalars, the same for all lanes. Strides are in texels: an image's
/// are whole texels, and an i32 then reaches all of it.
struct ImageCode {
  Value *base = nullptr;
  std::array<Value *, 3> size = {};   ///< i32: width, height, depth
  std::array<Value *, 2> stride = {}; ///< i32: of a row, of a slice
  abi::Format format;
};
/// Loads the fields of one image of a texture.
/// \param view pointer to the abi::TextureView
/// \param image i32, a scalar: which of TextureView::levels
/// \param dimensions 1 to 3; sizes and strides of the others stay null
[[nodiscard]] ImageCode loadImage(Code &code, const abi::Format &format, Value *view, Value *image,
                                  int dimensions);

/// The coordinates of one image; those of a cube map's face.
[[nodiscard]] inline int dimensionsOf(abi::Dimension dimension) {
  return dimension == abi::Dimension::Tex1D ? 1 : dimension == abi::Dimension::Tex3D ? 3 : 2;
}

/// Fraction bits of the integer weights by which texels of bytes are filtered: the host's.
inline constexpr int kWeightBits = 8;

/// A dimension's texels: the one of a nearest filter, or the two neighbours of a linear one.
struct AxisTexels {
  std::array<Value *, 2> index = {};   ///< i32, in [0, size) whatever the coordinate was
  std::array<Value *, 2> outside = {}; ///< lanes where it is the border instead; null: none
  Value *fraction = nullptr;           ///< weight of the second, in [0,1)
  Value *weight = nullptr;             ///< of bytes, as an integer in [0, 2^kWeightBits)
  /// Which texel the second one is, where that is known.
  enum class Next {
    Any,
    Edge,   ///< the one after the first; at the last texel that itself, without weight
    Repeat, ///< the one after the first; at the last texel the first of all
  } next = Next::Any;
};
/// How a dimension's coordinate becomes texels (OpenGL 1.4, 3.8.7 and 3.8.8).
struct AxisKey {
  abi::Wrap wrap = abi::Wrap::Repeat;
  bool normalized = true;  ///< the coordinate spans the image in [0,1]; else texels (rectangles)
  bool powerOfTwo = false; ///< the size is known to be one: indices wrap by a mask
};
/// The texel that a nearest filter takes. \param size i32, of the dimension, in texels
[[nodiscard]] AxisTexels nearestTexel(Code &code, const AxisKey &key, Value *coordinate,
                                      Value *size);
/// The two texels that a linear filter takes.
[[nodiscard]] AxisTexels linearTexels(Code &code, const AxisKey &key, Value *coordinate,
                                      Value *size);
/// The same with AxisTexels::weight, by the host's steps. The wrap mode is one of filtersBytes().
[[nodiscard]] AxisTexels linearTexelsOfBytes(Code &code, const AxisKey &key, Value *coordinate,
                                             Value *size);
/// Whether the border colour can be among a filter's texels with this wrap mode.
[[nodiscard]] bool reachesBorder(abi::Wrap wrap, bool linear);

/// The 32-bit words of a texel: words[i] holds its bytes 4*i to 4*i+3, in memory's order. Bytes
/// beyond a smaller texel are undefined.
using Words = std::array<Value *, 4>;
/// Bit i: word i is needed for `needed` components of the swizzle.
[[nodiscard]] unsigned wordsNeeded(const abi::Format &format, unsigned needed);
/// decode() of texels that are there as words: components outside `needed` are null.
[[nodiscard]] Vec decodeWords(Code &code, const abi::Format &format, const Words &words,
                              unsigned needed);

/// One texel a lane, loaded by one vector where the lanes' texels are near each other.
/// \param index i32 a lane, of the texel in the image, in texels from its base
/// \param words the bits of wordsNeeded(); the other words are null
[[nodiscard]] Words fetchTexels(Code &code, abi::Lanes lanes, const ImageCode &image, Value *index,
                                unsigned words);
/// Two neighbours of a row, of a format of 32 bits or less, as words: a smaller texel's in the low
/// bits.
struct TexelPair {
  Value *first = nullptr, *second = nullptr;
};
/// \param row0,row1 what the rows add to a texel's index, i32; row1 may be null, as its pair then
/// is
[[nodiscard]] std::array<TexelPair, 2> fetchFootprint(Code &code, abi::Lanes lanes,
                                                      const ImageCode &image, const AxisTexels &x,
                                                      Value *row0, Value *row1);

/// A face of a cube map and the way to it: table 3.21.
class CubeFace {
public:
  /// \param direction s, t, r of the lookup, of any length
  CubeFace(Code &code, const Vec &direction);
  [[nodiscard]] Value *face() const { return m_face; } ///< i32: 0 to 5
  /// s and t on the face, in [0,1].
  [[nodiscard]] Vec coordinate() const;
  /// By how much s and t change where the direction changes by \p change.
  [[nodiscard]] Vec derivative(const std::array<Value *, 3> &change) const;

private:
  /// s and t before the division, and the major axis's magnitude: linear in the direction.
  [[nodiscard]] Vec turned(const Vec &direction) const;
  Code &m_code;
  Value *m_majorX, *m_majorZ, *m_negative; ///< masks
  Value *m_face;
  Vec m_turned;
  Value *m_inverse; ///< of the major axis's magnitude
};

/// By how much coordinates change, a pixel in x and in y; all null where that is not known, and the
/// level of detail is then the base level's.
struct Derivatives {
  std::array<Value *, 3> dx = {}, dy = {};
};
[[nodiscard]] Derivatives derivativesOf(Code &code, const abi::SamplerKey &key, abi::Lanes lanes,
                                        const SampleAt &at);
/// The ways that a pixel in x and one in y make in the texture, in texels of the base level. Both
/// have as many components as an image has dimensions; the rest is null.
[[nodiscard]] std::array<Vec, 2> inTexels(Code &code, const abi::SamplerKey &key, Value *view,
                                          const Derivatives &d, const CubeFace *cube);
/// Of what inTexels() gives.
[[nodiscard]] Value *dot(Code &code, const Vec &a, const Vec &b);
/// log2 of what is not negative, linear between powers of two, which are exact: up to 0.086 less
/// than the logarithm. Of the square of a scale factor it is what software hosts take levels by,
/// and as no level of two is to change with who draws, the rasterizer has levels that are up to
/// 0.043 less than 3.8.8's, too. Zero is -127, an infinity or NaN at least 128.
[[nodiscard]] Value *linearLog2(Code &code, Value *x);
/// The same within 2^-14: a weight of 8-bit texels needs no more. An infinity or NaN is 128.
[[nodiscard]] Value *quickLog2(Code &code, Value *x);
/// \p lambda with all biases, clamped (3.8.8).
[[nodiscard]] Value *biasedLevel(Code &code, const abi::SamplerKey &key, Value *view,
                                 const SampleAt &at, Value *lambda);
/// Lambda, with biases and clamps (3.8.8): per lane, in levels from the base level.
/// \param view pointer to the abi::TextureView; \param cube of a cube map, else null
[[nodiscard]] Value *levelOfDetail(Code &code, const abi::SamplerKey &key, abi::Lanes lanes,
                                   Value *view, const SampleAt &at, const CubeFace *cube);

/// What a pixel covers of a texture, where that may be longer than wide: several samples stand for
/// it, side by side along its longer axis.
struct PixelFootprint {
  Value *lambda = nullptr; ///< of one sample, biased and clamped
  Value *count = nullptr;  ///< samples, as floats: whole numbers from 1 to kMaxAnisotropy
  Vec axis = {};           ///< the longer axis, as a change of the coordinates
};
/// \param d not null
[[nodiscard]] PixelFootprint footprintOf(Code &code, const abi::SamplerKey &key, Value *view,
                                         const SampleAt &at, const Derivatives &d,
                                         const CubeFace *cube);

/// Which levels a minified lookup reads: i32 a lane, in [0, levelCount).
struct LevelChoice {
  Value *first = nullptr;
  Value *second = nullptr;   ///< of a linear filter between levels, else null
  Value *fraction = nullptr; ///< weight of the second
};
/// The levels that a filter between levels reads at \p lambda (3.8.8).
[[nodiscard]] LevelChoice chooseLevels(Code &code, const abi::SamplerKey &key, Value *view,
                                       Value *lambda);

/// What a filter reads: an image and where in it.
struct Lookup {
  const abi::SamplerKey &key;
  abi::Lanes lanes;
  Value *view;
  ImageCode image;
  int dimensions = 2;
  Vec coordinate = {};        ///< of the image; a cube map's are those of its face
  Value *reference = nullptr; ///< what a shadow comparison compares with
  int borderDepth = 0;        ///< of a shadow comparison: the border colour's component to compare
  unsigned needed = 0xF;
};
/// a where the weight is 0, b where it is 1.
[[nodiscard]] Value *lerp(Code &code, Value *a, Value *b, Value *weight);
/// Where both indices of each dimension are in the image: what they add to a texel's index. The
/// first dimension's are the indices themselves.
using Steps = std::array<std::array<Value *, 2>, 3>;
[[nodiscard]] Steps stepsOf(Code &code, const ImageCode &image,
                            const std::array<AxisTexels, 3> &axes, int dimensions);
/// The nearest texel. With a shadow comparison the first component is its result, 0 or 1.
[[nodiscard]] Texel filterNearest(Code &code, const Lookup &lookup);
/// The mean of 2, 4 or 8 texels by their weights, after a shadow comparison of each.
[[nodiscard]] Texel filterLinear(Code &code, const Lookup &lookup);
/// Components of 8 bits or less that nothing decodes.
[[nodiscard]] constexpr bool fitsBytes(const abi::Format &format) {
  using abi::Layout;
  return ((format.layout >= Layout::U8x1 && format.layout <= Layout::U8x4) ||
          (abi::isPacked(format.layout) && format.layout != Layout::Bits1010102)) &&
         format.srgb == 0;
}
/// Whether the host filters such a lookup in bytes, between levels too: texels that fit bytes, with
/// a wrap mode that needs neither a border nor a mirror.
[[nodiscard]] bool filtersBytes(const Lookup &lookup);
/// A packed texel whose components have 8 bits or less as one of bytes, by the host's steps: it
/// repeats their bits.
[[nodiscard]] Value *bytesOfPacked(Code &code, abi::Layout layout, Value *word);
/// Returns the bytes of a texel that are filtered for `needed` components: bit 0 for 0 and 2, bit 1
/// for 1 and 3.
[[nodiscard]] unsigned bytesNeeded(const abi::Format &format, unsigned needed);
/// Between two levels' texels, as they lie in memory. Requires: filtersBytes().
[[nodiscard]] Texel mixBytes(Code &code, const Lookup &lookup, Value *first, Value *second,
                             Value *fraction);
/// The linear filter of texels of bytes, in integers. Texel::packed has the bytes that are needed,
/// whatever the format. Requires: filtersBytes().
[[nodiscard]] Texel filterBytes(Code &code, const Lookup &lookup,
                                const std::array<AxisTexels, 3> &axes);

/// Control flow by a scalar i1: the values of the branch that was taken. Both give as many; one
/// that is null in either is null afterwards.
using Values = llvm::SmallVector<Value *, 5>;
[[nodiscard]] Values eitherOf(Code &code, Value *condition, const std::function<Values()> &yes,
                              const std::function<Values()> &no);
using Sampled = std::function<Texel()>;
/// eitherOf() of the components of texels.
[[nodiscard]] Texel either(Code &code, Value *condition, const Sampled &yes, const Sampled &no);
/// A loop over the images that lanes ask for, each with \p sampled of its number (a scalar i32):
/// mostly there is but one.
/// \param image i32 a lane, safe in every lane
/// \param mask lanes that count, or null
[[nodiscard]] Texel forEachImage(Code &code, Value *image, Value *mask,
                                 const std::function<Texel(Value *)> &sampled);
/// The mean of as many samples as each lane asks for: a loop, as long as the lane with the most.
/// \param count floats, whole numbers from 1 on; \param mask lanes that count, or null
/// \param sampled of a place in (-1/2, 1/2), a lane each: 0 where there is but one
[[nodiscard]] Texel meanOf(Code &code, Value *count, Value *mask,
                           const std::function<Texel(Value *)> &sampled);

} // namespace arbiter::fp::llvm_back
