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
/// Nothing where the program or the state ask for more, or where the program is so short that
/// looking up takes longer than running it.
[[nodiscard]] std::optional<ByteProgram>
byteProgramOf(const Cpu &cpu, const jit::FragmentProgram &program, const abi::FragmentKey &key);

class ByteTables {
public:
  /// Between the function's entry and its first item: decides whether the call has pixels enough,
  /// and makes the tables. Leaves the builder in a block that goes on to the item.
  /// \param pixelsOf the colours of a vector of texels, as they would be stored
  ByteTables(Code &code, const ByteProgram &program, Value *items, Value *itemCount,
             const Places &places, const std::function<Value *(Value *texels)> &pixelsOf);

  /// i1: the tables are there.
  [[nodiscard]] Value *ready();
  /// Before a loop.
  void load();
  /// A vector of pixels, of i32, made from the texels that lie at \p texels.
  [[nodiscard]] Value *pixels(Value *texels);

private:
  static constexpr unsigned kWords = 1024; ///< bytes of a table of 256 words

  [[nodiscard]] llvm::VectorType *bytes() const;
  void splitTable(Value *pixelTable);
  [[nodiscard]] Value *tableOf(int source);
  [[nodiscard]] Value *permuted(Value *texels);
  [[nodiscard]] Value *lookedUp(Value *texels);

  Code &m_code;
  ByteProgram m_program;
  bool m_permutes; ///< the tables are of bytes and held in registers; else of words, in memory
  /// In the function's frame. Of bytes: one for each byte of a pixel. Of words: one for each byte
  /// of a texel, with the bytes of the pixel that are made from it.
  Value *m_tables = nullptr, *m_ready = nullptr;
  std::array<std::array<Value *, 4>, 4> m_loaded = {};
};

} // namespace arbiter::fp::llvm_back
