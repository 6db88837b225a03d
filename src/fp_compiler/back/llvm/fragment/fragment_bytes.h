#pragma once
#include <functional>
#include <optional>

#include "fp_compiler/back/llvm/fragment/fragment_consecutive.h"

/// Programs that change bytes one by one: brightness and contrast, gamma, inversion, thresholds.
/// Where each component of the colour is a function of one byte of a texel and of nothing else that
/// varies, the program is run once on the 256 bytes there are, and pixels are looked up.
namespace arbiter::fp::llvm_back {

struct ByteProgram {
  std::size_t sample = 0; ///< the texture instruction
  std::size_t target = 0; ///< the only colour buffer
  /// By byte of a pixel: the texel's byte that it is made from.
  std::array<int, 4> source = {};
};
/// Nothing where the program or the state ask for more, or the processor has no permutation of
/// bytes over several registers.
[[nodiscard]] std::optional<ByteProgram>
byteProgramOf(const Cpu &cpu, const jit::FragmentProgram &program, const abi::FragmentKey &key);

class ByteTables {
public:
  /// Between the function's entry and its first item: decides whether the call has pixels enough,
  /// and makes the tables. Leaves the builder in a block that goes on to the item.
  /// \param pixelsOf the colours of 16 texels, as they would be stored
  ByteTables(Code &code, const ByteProgram &program, Value *items, Value *itemCount,
             const Places &places, const std::function<Value *(Value *texels)> &pixelsOf);

  /// i1: the tables are there.
  [[nodiscard]] Value *ready();
  /// Before a loop.
  void load();
  /// The pixels of \p texels, lanes of i32.
  [[nodiscard]] Value *pixels(Value *texels);

private:
  [[nodiscard]] llvm::VectorType *bytes() const;

  Code &m_code;
  ByteProgram m_program;
  Value *m_tables = nullptr, *m_ready = nullptr; ///< in the function's frame
  std::array<std::array<Value *, 4>, 4> m_loaded = {};
};

} // namespace arbiter::fp::llvm_back
