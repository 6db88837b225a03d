#pragma once
#include <map>

#include "fp_compiler/back/llvm/fragment_affine.h"
#include "fp_compiler/back/llvm/pixel_memory.h"

/// The decision, once a span, whether all samples with affine coordinates read consecutive texels.
namespace arbiter::fp::llvm_back {

/// How near to a texel's centre, in texels, a linear filter's coordinate must stay. The general
/// code would weigh a neighbour by less than that: at most an eighth of a step of 8-bit components,
/// which storing them rounds away. Other formats take the general code.
inline constexpr double kLinearReach = 1.0 / 2048;

/// How a loop reads the samples whose texels are consecutive: like any other, as loads that need no
/// wrapping, or as loads on both sides of the texture's edge. Given: the one sample is at hand.
enum class SamplePath : std::uint8_t { General, Consecutive, Edge, Given };

class ConsecutiveSamples {
public:
  /// Written to the item's block.
  ConsecutiveSamples(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                     const Places &places, const AffineFlow &flow, Value *data, Value *count);

  /// Whether any sample of the program can be read so at all.
  [[nodiscard]] bool any() const { return !m_samples.empty(); }
  /// i1: whether all of them are consecutive over the whole span, but for wrapping.
  [[nodiscard]] Value *good() const { return m_good; }
  /// Pixels [begin, end) of the span, counted from its first, in which none wraps: a whole number
  /// of vectors after its start, and whole ones unless it ends with the span. Both are the span's
  /// count where there are none.
  [[nodiscard]] Value *begin() const { return m_begin; }
  [[nodiscard]] Value *end() const { return m_end; }
  [[nodiscard]] bool has(std::size_t index) const { return m_samples.contains(index); }
  /// For the texture instruction \p index: the texel of pixel \p column of the span, where none
  /// wraps.
  [[nodiscard]] Value *texels(std::size_t index, Value *column) const;
  /// The texels from that pixel on, wrapped; what decode() takes.
  [[nodiscard]] Value *wrappedTexels(std::size_t index, const PixelPlace &place) const;

private:
  struct Sample {
    const abi::SamplerKey *key;
    Value *row;   ///< pointer to texel 0
    Value *first; ///< i32: what the span's first pixel reads, unless it is wrapped
    Value *width; ///< i32
  };
  struct Axis {
    Value *first = nullptr; ///< the index that the first pixel reads, before wrapping, a double
    Value *good = nullptr;  ///< i1
  };
  [[nodiscard]] static bool isCandidate(const jit::FragmentProgram &program,
                                        const abi::FragmentKey &key, std::size_t index,
                                        const AffineFlow &flow);
  void add(std::size_t index, const AffineFlow::Axes &axes);
  [[nodiscard]] Axis axis(const Affine &coordinate, Value *size, bool normalised, bool linear,
                          bool advances);
  [[nodiscard]] Value *both(Value *a, Value *b);
  /// `lanes` texels from pointer \p row on, those whose index is in the row and that are wanted.
  [[nodiscard]] Value *part(const Sample &sample, Value *index, Value *wanted, Value *others) const;

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Value *m_data, *m_count;
  Value *m_last = nullptr; ///< count - 1, a double
  Value *m_good = nullptr, *m_begin = nullptr, *m_end = nullptr;
  std::map<std::size_t, Sample> m_samples;
};

} // namespace arbiter::fp::llvm_back
