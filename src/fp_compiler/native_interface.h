#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/limits.h"

/// The facts that GL needs of a program in one of NVIDIA's own languages, besides its IR.
namespace arbiter::fp {

/// A named local parameter of a !!FP1.0 program (NV_fragment_program 3.11.2). Its value is the
/// program object's local parameter `local`. That number is above all that program.local and p[]
/// can name: Limits::localParameters plus its index in NativeInterface::named.
struct NamedParameter {
  std::string name;
  std::uint16_t local = 0;
  ir::Vec4 value = {}; ///< the initial value from DECLARE
};

struct NativeInterface {
  ir::NativeLanguage language = ir::NativeLanguage::None;
  /// Names from DECLARE, which glProgramNamedParameter4fNV sets.
  std::vector<NamedParameter> named;
  /// Names from DEFINE, which no call can set.
  std::vector<std::string> constants;
  /// Bit n is set if v[n] is read, by number or by name. The program reads v[n] as the conventional
  /// attribute if it has a conventional name (0 position, 2 normal, 3 and 4 colours, 5 fog
  /// coordinate, 8 and up texture coordinates). It reads 1, 6 and 7 as generic attributes.
  std::uint16_t attributes = 0;
  /// The rows c[n] that are read by number, each once and in order. They are the vertex target's
  /// environment parameters.
  std::vector<std::uint16_t> rowsRead;
  /// True if c[A0.x + n] is read, so that any row may be.
  bool readsAnyRow = false;
  /// The rows that a vertex state program writes, each once and in order. They are outputs of the
  /// kind EnvParameter. ExecuteProgramNV is an error if one of them is tracked (NV_vertex_program
  /// 2.14.5).
  std::vector<std::uint16_t> rowsWritten;

  /// Returns the declared parameter of that name; nullptr if there is none.
  [[nodiscard]] const NamedParameter *find(std::string_view name) const {
    for (const NamedParameter &parameter : named)
      if (parameter.name == name)
        return &parameter;
    return nullptr;
  }
};

/// The most named parameters of a program.
inline constexpr std::uint32_t kMaxNamedParameters = 256;

/// Returns the language whose header a text begins with. Returns None for any other text, also for
/// a header that is refused.
[[nodiscard]] constexpr ir::NativeLanguage nativeLanguageOf(std::string_view text) {
  using ir::NativeLanguage;
  for (const NativeLanguage language :
       {NativeLanguage::Fp1, NativeLanguage::Vp1, NativeLanguage::Vp11, NativeLanguage::Vp2,
        NativeLanguage::Vsp1})
    if (text.starts_with(headerOf(language)))
      return language;
  return NativeLanguage::None;
}

/// True if a target of these limits accepts texts in that language. A target may have
/// NV_vertex_program's languages without NVIDIA's options.
[[nodiscard]] constexpr bool takesLanguage(const Limits &limits, ir::NativeLanguage language) {
  using ir::NativeLanguage;
  const bool first = language == NativeLanguage::Vp1 || language == NativeLanguage::Vp11 ||
                     language == NativeLanguage::Vsp1;
  return language != NativeLanguage::None &&
         (limits.nvOptions != 0 || (first && limits.nvVertexProgram != 0));
}

/// Returns the target that programs in the language are drawn with: ArbFragment or ArbVertex.
/// Requires: a language other than None.
[[nodiscard]] constexpr ir::Language stageOf(ir::NativeLanguage language) {
  return language == ir::NativeLanguage::Fp1 ? ir::Language::ArbFragment : ir::Language::ArbVertex;
}

} // namespace arbiter::fp
