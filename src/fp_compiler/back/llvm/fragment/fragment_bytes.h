#pragma once
#include <functional>
#include <optional>

#include "fp_compiler/back/llvm/fragment/fragment_consecutive.h"

/// Optimises programs that change bytes independently: brightness and contrast, gamma, inversion,
/// thresholds. Each colour component must depend on one byte of a texel and on nothing else that
/// varies. The program then runs once for all 256 byte values, and pixels are looked up in tables.
namespace arbiter::fp::llvm_back {

struct ByteProgram {
  std::size_t sample = 0; ///< the texture instruction
  std::size_t target = 0; ///< the only colour buffer
  /// The texel byte that each byte of a pixel depends on.
  std::array<int, 4> source = {};
};
/// Returns nothing if the program or the state does not qualify, or if the program is so short that
/// look-ups would take longer.
[[nodiscard]] std::optional<ByteProgram>
byteProgramOf(const Cpu &cpu, const jit::FragmentProgram &program, const abi::FragmentKey &key);

class ByteTables {
public:
  /// Decides whether the call has enough pixels, and fills the tables. Stands between the
  /// function's entry and its first item. Leaves the builder in a block that continues to the item.
  /// \param pixelsOf returns the pixels for a vector of texels, as they would be stored
  ByteTables(Code &code, const ByteProgram &program, Value *items, Value *itemCount,
             const Places &places, const std::function<Value *(Value *texels)> &pixelsOf);

  /// Returns an i1: true if the tables are filled.
  [[nodiscard]] Value *ready();
  /// Loads tables into registers before a loop.
  void load();
  /// Returns a vector of pixels (i32) for the texels at \p texels.
  [[nodiscard]] Value *pixels(Value *texels);

private:
  static constexpr unsigned kWords = 1024; ///< size of a table of 256 words in bytes

  [[nodiscard]] llvm::VectorType *bytes() const;
  void splitTable(Value *pixelTable);
  [[nodiscard]] Value *tableOf(int source);
  [[nodiscard]] Value *permuted(Value *texels);
  [[nodiscard]] Value *lookedUp(Value *texels);

  Code &m_code;
  ByteProgram m_program;
  bool m_permutes; ///< true: tables of bytes in registers; false: tables of words in memory
  /// Tables in the function's frame. Byte tables: one for each byte of a pixel. Word tables: one
  /// for each byte of a texel, with the pixel bytes that depend on it.
  Value *m_tables = nullptr, *m_ready = nullptr;
  std::array<std::array<Value *, 4>, 4> m_loaded = {};
};

} // namespace arbiter::fp::llvm_back
