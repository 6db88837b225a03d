#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fp_compiler/back/llvm/interpolate.h"
#include "fp_compiler/jit.h"

/// Texture coordinates that are affine functions of a span's pixels: found by a walk over the
/// program, tested once a span. Where every pixel of a span reads the texel next to its
/// neighbour's, the loop loads texels as they lie.
namespace arbiter::fp::llvm_back {

/// A component of a register over a span, as scalars of the item's block, doubles: the value of
/// pixel i is `base + slope * i`, and what the lanes compute differs from it by at most
/// `magnitude * rounds * 2^-24`.
struct Affine {
  Value *base = nullptr;
  Value *slope = nullptr;     ///< null: the same for all pixels
  Value *slopeY = nullptr;    ///< from a row to the next; null: none
  Value *magnitude = nullptr; ///< of the value and of all it was made from, over the span
  int rounds = 0;
};

/// The samples of a program whose coordinates are affine.
class AffineFlow {
public:
  using Axes = std::array<std::optional<Affine>, 4>;

  /// \param count pixels of the span, i32
  AffineFlow(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
             const Places &places, Interpolator &interpolator, Value *data, Value *count);

  /// s, t, r, q of the texture instruction \p index of the code, where they are affine.
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

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Interpolator &m_interpolator;
  Value *m_data, *m_count;
  std::vector<Axes> m_temporaries;
  std::map<std::size_t, Axes> m_samples;
};

} // namespace arbiter::fp::llvm_back
