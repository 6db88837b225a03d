#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fp_compiler/back/llvm/fragment/fragment_spans.h"
#include "fp_compiler/jit.h"

/// Finds texture coordinates that are affine functions of a span's pixels. It walks the program at
/// compile time, and the code tests them once for each span. If neighbouring pixels read
/// neighbouring texels, the loop uses plain vector loads.
namespace arbiter::fp::llvm_back {

/// A register component over a span, as doubles. The value of pixel i is `base + slope * i`. The
/// value in a lane differs from it by at most `magnitude * rounds * 2^-24`. Values common to all
/// spans are scalars in the entry block; the others are vectors of the group.
struct Affine {
  Value *base = nullptr;
  Value *slope = nullptr;     ///< scalar; null: equal for all pixels
  Value *slopeY = nullptr;    ///< scalar, from a row to the next; null: none
  Value *magnitude = nullptr; ///< of the value and all its inputs, over the span
  int rounds = 0;
};

/// Finds the samples of a program whose coordinates are affine.
class AffineFlow {
public:
  using Axes = std::array<std::optional<Affine>, 4>;

  AffineFlow(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
             const Places &places, Interpolator &interpolator, Value *data, const SpanGroup &spans);

  /// Returns s, t, r, q of the texture instruction at \p index, where they are affine.
  [[nodiscard]] const Axes *coordinate(std::size_t index) const;
  [[nodiscard]] Value *number(double value) const;

private:
  void step(const ir::Instruction &instruction);
  [[nodiscard]] std::optional<Affine> read(const ir::Operand &operand, int component);
  [[nodiscard]] std::optional<Affine> attribute(int index, int component);
  [[nodiscard]] std::optional<Affine> position(int component);
  [[nodiscard]] std::optional<Affine> result(const ir::Instruction &instruction, int component);
  [[nodiscard]] std::optional<Affine> dot(const ir::Instruction &instruction, int terms,
                                          bool homogeneous);
  [[nodiscard]] std::optional<Affine> add(const std::optional<Affine> &a,
                                          const std::optional<Affine> &b);
  [[nodiscard]] std::optional<Affine> multiply(const std::optional<Affine> &a,
                                               const std::optional<Affine> &b);
  [[nodiscard]] Affine uniform(Value *scalar);
  [[nodiscard]] Value *magnitudeOf(Value *value);
  [[nodiscard]] Value *sum(Value *a, Value *b);
  [[nodiscard]] Value *product(Value *a, Value *b);
  [[nodiscard]] Value *greater(Value *a, Value *b);
  [[nodiscard]] std::optional<Affine> negated(std::optional<Affine> value, bool negate);
  [[nodiscard]] Value *wide(Value *number); ///< converts floats and integers to double
  /// Applies \p make to the operands: once for each call if all are scalars, else once for each
  /// group.
  template <typename Make, typename... Values> Value *made(Make make, Values... operands) {
    if (!(operands->getType()->isVectorTy() || ...))
      return writeIn(m_code, m_places.entry, [&] { return make(operands...); });
    return make(m_spans.inLanes(operands)...);
  }

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Interpolator &m_interpolator;
  Value *m_data;
  const SpanGroup &m_spans;
  std::vector<Axes> m_temporaries;
  std::map<std::size_t, Axes> m_samples;
};

} // namespace arbiter::fp::llvm_back
