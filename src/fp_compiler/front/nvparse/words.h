#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/texture_shader/state.h"

/// The words of nvparse's texts. They are case-sensitive, as in its lexers.
namespace arbiter::fp::nvparse {

/// A register that a word names.
struct NamedRegister {
  combiners::Register name = combiners::Register::Zero;
  bool one = false; ///< "one": Zero, inverted
};
/// Returns the register for a word such as "tex3"; nothing for any other word.
[[nodiscard]] std::optional<NamedRegister> registerOf(std::string_view word);
/// Returns the word of a register: "tex3".
[[nodiscard]] std::string wordOf(combiners::Register name);
/// Returns the words of registers, with their numbers, as candidates for suggestions.
[[nodiscard]] std::vector<std::string_view> registerWords();

/// The arguments in the parentheses of a texture shader's stage.
enum class Arguments : std::uint8_t {
  None,
  Cull,     ///< four comparisons
  Previous, ///< a texture
  Matrix,   ///< a texture and four numbers
  Scale,    ///< a texture, four numbers, a scale and a bias
  Dot,      ///< a texture, in expand() or not
  Eye,      ///< the same, and three numbers
};

/// A row of the table of stages.
struct OperationWord {
  std::string_view word;
  texture_shader::Operation operation = texture_shader::Operation::None;
  std::uint8_t stage = 1;  ///< the place in a run of stages, from 1
  std::uint8_t stages = 1; ///< of the run
  Arguments arguments = Arguments::None;
  std::uint8_t extension = 1; ///< the NV_texture_shader that has it
  const char *doc = "";

  /// Returns the common part of the words of a run: "dot_product_2d_" for "dot_product_2d_1of2".
  [[nodiscard]] std::string_view run() const {
    return stages == 1 ? word : word.substr(0, word.size() - 4);
  }
};
[[nodiscard]] std::span<const OperationWord> operationWords();
/// Returns the row of a word; nullptr for any other word.
[[nodiscard]] const OperationWord *operationOf(std::string_view word);

} // namespace arbiter::fp::nvparse
