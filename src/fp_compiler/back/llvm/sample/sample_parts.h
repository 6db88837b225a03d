#pragma once
#include <functional>

#include "fp_compiler/back/llvm/code/code.h"

/// The parts of sample(): texel positions (wrap), reading (fetch), conversion (decode), and
/// filters.
namespace arbiter::fp::llvm_back {

/// Loads a value that does not change while the function runs. LLVM can then move the load out of
/// loops despite the stores to colour buffers.
[[nodiscard]] Value *constantField(Code &code, llvm::Type *type, Value *pointer,
                                   std::size_t offset);

/// Returns an i1: true if any lane of \p mask (i1 lanes) is set.
[[nodiscard]] Value *anyLane(Code &code, Value *mask);
/// Returns an i1: true if all lanes of \p mask are set.
[[nodiscard]] Value *allLanes(Code &code, Value *mask);

/// One image in generated code, as scalars common to all lanes. Strides are in texels, which are
/// whole numbers. An i32 can then address the whole image.
struct ImageCode {
  Value *base = nullptr;
  std::array<Value *, 3> size = {};   ///< i32: width, height, depth
  std::array<Value *, 2> stride = {}; ///< i32: of a row, of a slice
  abi::Format format;
};
/// Loads the fields of one image of a texture.
/// \param view pointer to the abi::TextureView
/// \param image scalar i32: index into TextureView::levels
/// \param dimensions 1 to 3; sizes and strides of the others stay null
[[nodiscard]] ImageCode loadImage(Code &code, const abi::Format &format, Value *view, Value *image,
                                  int dimensions);

/// Returns the number of coordinates of one image. For a cube map it is that of a face.
[[nodiscard]] inline int dimensionsOf(abi::Dimension dimension) {
  return dimension == abi::Dimension::Tex1D ? 1 : dimension == abi::Dimension::Tex3D ? 3 : 2;
}

/// Number of fraction bits of the integer weights that filter byte texels, as in the host.
inline constexpr int kWeightBits = 8;

/// The texels in one dimension: one for a nearest filter, or two neighbours for a linear one.
struct AxisTexels {
  std::array<Value *, 2> index = {};   ///< i32, in [0, size) for any coordinate
  std::array<Value *, 2> outside = {}; ///< lanes that take the border instead; null: none
  Value *fraction = nullptr;           ///< weight of the second texel, in [0,1)
  Value *weight = nullptr; ///< for byte texels: the weight as an integer in [0, 2^kWeightBits)
  /// The position of the second texel relative to the first, where it is known.
  enum class Next {
    Any,
    Edge,   ///< the following texel; at the last texel the same one, without weight
    Repeat, ///< the following texel; at the last texel the first of all
  } next = Next::Any;
};
/// How a coordinate becomes texels in one dimension (OpenGL 1.4, 3.8.7 and 3.8.8).
struct AxisKey {
  abi::Wrap wrap = abi::Wrap::Repeat;
  bool normalized = true;  ///< the image spans [0,1]; else coordinates are in texels (rectangles)
  bool powerOfTwo = false; ///< the size is a power of two, so that indices wrap by a mask
};
/// Returns the texel of a nearest filter.
/// \param size i32, of the dimension, in texels
[[nodiscard]] AxisTexels nearestTexel(Code &code, const AxisKey &key, Value *coordinate,
                                      Value *size);
/// Returns the two texels of a linear filter.
[[nodiscard]] AxisTexels linearTexels(Code &code, const AxisKey &key, Value *coordinate,
                                      Value *size);
/// Returns the two texels of a linear filter on bytes, with AxisTexels::weight, by the host's
/// steps. Requires: filtersBytes() allows the wrap mode.
[[nodiscard]] AxisTexels linearTexelsOfBytes(Code &code, const AxisKey &key, Value *coordinate,
                                             Value *size);
/// True if a filter with this wrap mode may read the border colour.
[[nodiscard]] bool reachesBorder(abi::Wrap wrap, bool linear);

/// The 32-bit words of a texel: words[i] holds bytes 4*i to 4*i+3 in memory order. Bytes beyond a
/// smaller texel are undefined.
using Words = std::array<Value *, 4>;
/// Returns which words the `needed` components of the swizzle depend on: bit i for word i.
[[nodiscard]] unsigned wordsNeeded(const abi::Format &format, unsigned needed);
/// Converts texels given as words, like decode(). Components outside `needed` are null.
[[nodiscard]] Vec decodeWords(Code &code, const abi::Format &format, const Words &words,
                              unsigned needed);

/// Fetches one texel for each lane. One vector load does it if the texels are close to each other.
/// \param index i32 lanes: the texel's index from the image's base
/// \param words the result of wordsNeeded(); the other words are null
[[nodiscard]] Words fetchTexels(Code &code, abi::Lanes lanes, const ImageCode &image, Value *index,
                                unsigned words);
/// Two neighbouring texels in a row, of at most 32 bits, as words. A smaller texel is in the low
/// bits.
struct TexelPair {
  Value *first = nullptr, *second = nullptr;
};
/// Fetches a pair of texels from each of two rows.
/// \param row0,row1 i32: a row's contribution to the texel index. If row1 is null, so is its pair.
[[nodiscard]] std::array<TexelPair, 2> fetchFootprint(Code &code, abi::Lanes lanes,
                                                      const ImageCode &image, const AxisTexels &x,
                                                      Value *row0, Value *row1);

/// A face of a cube map and the projection to it (table 3.21).
class CubeFace {
public:
  /// \param direction s, t, r of the lookup, of any length
  CubeFace(Code &code, const Vec &direction);
  [[nodiscard]] Value *face() const { return m_face; } ///< i32: 0 to 5
  /// Returns s and t on the face, in [0,1].
  [[nodiscard]] Vec coordinate() const;
  /// Returns the change of s and t when the direction changes by \p change.
  [[nodiscard]] Vec derivative(const std::array<Value *, 3> &change) const;

private:
  /// Returns s and t before the division, and the major axis's magnitude. They are linear in the
  /// direction.
  [[nodiscard]] Vec turned(const Vec &direction) const;
  Code &m_code;
  Value *m_majorX, *m_majorZ, *m_negative; ///< masks
  Value *m_face;
  Vec m_turned;
  Value *m_inverse; ///< reciprocal of the major axis's magnitude
};

/// Changes of the coordinates for one pixel in x and in y. All are null if unknown, and the level
/// of detail is then the base level.
struct Derivatives {
  std::array<Value *, 3> dx = {}, dy = {};
};
[[nodiscard]] Derivatives derivativesOf(Code &code, const abi::SamplerKey &key, abi::Lanes lanes,
                                        const SampleAt &at);
/// Returns the derivatives in texels of the base level. Both vectors have as many components as an
/// image has dimensions; the rest is null.
[[nodiscard]] std::array<Vec, 2> inTexels(Code &code, const abi::SamplerKey &key, Value *view,
                                          const Derivatives &d, const CubeFace *cube);
/// Returns the dot product of two vectors from inTexels().
[[nodiscard]] Value *dot(Code &code, const Vec &a, const Vec &b);
/// Returns an approximation of log2 of a number that is not negative. It is linear between powers
/// of two, where it is exact, and at most 0.086 too small. Software hosts compute levels from it
/// for the square of the scale factor. The rasterizer must select the same levels, so its levels
/// too are up to 0.043 below 3.8.8's. Zero gives -127; infinity and NaN give at least 128.
[[nodiscard]] Value *linearLog2(Code &code, Value *x);
/// Returns log2 of a number that is not negative, within 2^-14. Weights of 8-bit texels need no
/// more. Infinity and NaN give 128.
[[nodiscard]] Value *quickLog2(Code &code, Value *x);
/// Returns \p lambda with all biases, clamped (3.8.8).
[[nodiscard]] Value *biasedLevel(Code &code, const abi::SamplerKey &key, Value *view,
                                 const SampleAt &at, Value *lambda);
/// Returns lambda with biases and clamps (3.8.8) in each lane, in levels from the base level.
/// \param view pointer to the abi::TextureView
/// \param cube the face of a cube map, else null
[[nodiscard]] Value *levelOfDetail(Code &code, const abi::SamplerKey &key, abi::Lanes lanes,
                                   Value *view, const SampleAt &at, const CubeFace *cube);

/// The footprint of a pixel in a texture, for anisotropic filters. Several samples along its longer
/// axis cover it.
struct PixelFootprint {
  Value *lambda = nullptr; ///< level of one sample, biased and clamped
  Value *count = nullptr;  ///< number of samples, as floats: whole numbers from 1 to kMaxAnisotropy
  Vec axis = {};           ///< the longer axis, as a change of the coordinates
};
/// Returns the footprint of each lane's pixel.
/// \param d not null
[[nodiscard]] PixelFootprint footprintOf(Code &code, const abi::SamplerKey &key, Value *view,
                                         const SampleAt &at, const Derivatives &d,
                                         const CubeFace *cube);

/// The levels that a minified lookup reads: i32 lanes, in [0, levelCount).
struct LevelChoice {
  Value *first = nullptr;
  Value *second = nullptr;   ///< for a linear filter between levels, else null
  Value *fraction = nullptr; ///< weight of the second level
};
/// Returns the levels that a filter between levels reads at \p lambda (3.8.8).
[[nodiscard]] LevelChoice chooseLevels(Code &code, const abi::SamplerKey &key, Value *view,
                                       Value *lambda);

/// The input of a filter: an image and a position in it.
struct Lookup {
  const abi::SamplerKey &key;
  abi::Lanes lanes;
  Value *view;
  ImageCode image;
  int dimensions = 2;
  Vec coordinate = {};        ///< in the image; for a cube map in its face
  Value *reference = nullptr; ///< reference value of a shadow comparison
  int borderDepth = 0;        ///< shadow comparison: component of the border colour to compare
  unsigned needed = 0xF;
};
/// Interpolates: weight 0 gives a, weight 1 gives b.
[[nodiscard]] Value *lerp(Code &code, Value *a, Value *b, Value *weight);
/// For both indices of each dimension: their contribution to a texel's index. In the first
/// dimension it is the index itself.
using Steps = std::array<std::array<Value *, 2>, 3>;
[[nodiscard]] Steps stepsOf(Code &code, const ImageCode &image,
                            const std::array<AxisTexels, 3> &axes, int dimensions);
/// Returns the nearest texel. With a shadow comparison, the first component is its result, 0 or 1.
[[nodiscard]] Texel filterNearest(Code &code, const Lookup &lookup);
/// Returns the weighted mean of 2, 4 or 8 texels, after a shadow comparison of each.
[[nodiscard]] Texel filterLinear(Code &code, const Lookup &lookup);
/// True if the components have 8 bits or less and are not sRGB-encoded.
[[nodiscard]] constexpr bool fitsBytes(const abi::Format &format) {
  using abi::Layout;
  return ((format.layout >= Layout::U8x1 && format.layout <= Layout::U8x4) ||
          (abi::isPacked(format.layout) && format.layout != Layout::Bits1010102)) &&
         format.srgb == 0;
}
/// True if the host uses byte arithmetic to filter such a lookup, also between levels. The texels
/// must fit bytes, and the wrap mode must need neither border nor mirror.
[[nodiscard]] bool filtersBytes(const Lookup &lookup);
/// Expands a packed texel with components of 8 bits or less to bytes, by the host's steps: it
/// repeats their bits.
[[nodiscard]] Value *bytesOfPacked(Code &code, abi::Layout layout, Value *word);
/// Returns the bytes of a texel that are filtered for `needed` components: bit 0 for 0 and 2, bit 1
/// for 1 and 3.
[[nodiscard]] unsigned bytesNeeded(const abi::Format &format, unsigned needed);
/// Interpolates between two levels' texels, in memory form. Requires: filtersBytes().
[[nodiscard]] Texel mixBytes(Code &code, const Lookup &lookup, Value *first, Value *second,
                             Value *fraction);
/// Filters byte texels linearly in integer arithmetic. Texel::packed has the bytes that are needed,
/// for any format. Requires: filtersBytes().
[[nodiscard]] Texel filterBytes(Code &code, const Lookup &lookup,
                                const std::array<AxisTexels, 3> &axes);

/// Writes a branch on a scalar i1 and returns the values of the branch taken. Both branches must
/// give the same number of values. A value that is null in either is null in the result.
using Values = llvm::SmallVector<Value *, 5>;
[[nodiscard]] Values eitherOf(Code &code, Value *condition, const std::function<Values()> &yes,
                              const std::function<Values()> &no);
using Sampled = std::function<Texel()>;
/// Applies eitherOf() to the components of texels.
[[nodiscard]] Texel either(Code &code, Value *condition, const Sampled &yes, const Sampled &no);
/// Writes a loop over the images that the lanes use, and samples each by its index (a scalar i32).
/// Mostly there is only one.
/// \param image i32 lanes, valid in every lane
/// \param mask lanes that are needed, or null
[[nodiscard]] Texel forEachImage(Code &code, Value *image, Value *mask,
                                 const std::function<Texel(Value *)> &sampled);
/// Returns the mean of a number of samples that differs by lane. The loop runs as long as the lane
/// with the most.
/// \param count floats, whole numbers from 1 on
/// \param mask lanes that are needed, or null
/// \param sampled samples at a place in (-1/2, 1/2), different in each lane; 0 for a single sample
[[nodiscard]] Texel meanOf(Code &code, Value *count, Value *mask,
                           const std::function<Texel(Value *)> &sampled);

} // namespace arbiter::fp::llvm_back
