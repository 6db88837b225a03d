#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/limits.h"

/// What GL has to know of a program in one of NVIDIA's languages of their own, beside its IR.
namespace arbiter::fp {

/// A named local parameter of a !!FP1.0 program (NV_fragment_program 3.11.2). Its value is the
/// program object's local parameter `local`, a number above all that program.local and p[] reach:
/// Limits::localParameters plus its place in NativeInterface::named.
struct NamedParameter {
  std::string name;
  std::uint16_t local = 0;
  ir::Vec4 value = {}; ///< what DECLARE gives it when the program is loaded
};

struct NativeInterface {
  ir::NativeLanguage language = ir::NativeLanguage::None;
  /// DECLARE's names, which glProgramNamedParameter4fNV sets.
  std::vector<NamedParameter> named;
  /// DEFINE's names: no call reaches them.
  std::vector<std::string> constants;
  /// Bit n: v[n] is read, by number or by name. The program reads those that have a conventional
  /// name (0 position, 2 normal, 3 and 4 colours, 5 fog coordinate, 8 and up texture coordinates)
  /// as the conventional attribute, and 1, 6 and 7 as the generic one.
  std::uint16_t attributes = 0;
  /// The rows c[n] that are read by number, each once and in order; they are the vertex target's
  /// environment parameters.
  std::vector<std::uint16_t> rowsRead;
  /// c[A0.x + n] is read: any row may be.
  bool readsAnyRow = false;
  /// The rows that a vertex state program writes, each once and in order: outputs of the kind
  /// EnvParameter. One that is tracked makes ExecuteProgramNV an error (NV_vertex_program 2.14.5).
  std::vector<std::uint16_t> rowsWritten;

  /// The declared parameter of that name; nullptr if there is none.
  [[nodiscard]] const NamedParameter *find(std::string_view name) const {
    for (const NamedParameter &parameter : named)
      if (parameter.name == name)
        return &parameter;
    return nullptr;
  }
};

/// No program declares more named parameters.
inline constexpr std::uint32_t kMostNamedParameters = 256;

/// The language whose header a text begins with; None for any other text, a refused header too.
[[nodiscard]] constexpr ir::NativeLanguage nativeLanguageOf(std::string_view text) {
  using ir::NativeLanguage;
  for (const NativeLanguage language :
       {NativeLanguage::Fp1, NativeLanguage::Vp1, NativeLanguage::Vp11, NativeLanguage::Vp2,
        NativeLanguage::Vsp1})
    if (text.starts_with(headerOf(language)))
      return language;
  return NativeLanguage::None;
}

/// Whether a target of these limits takes texts of that language. Those of NV_vertex_program are
/// there before the options, and with them.
[[nodiscard]] constexpr bool takesLanguage(const Limits &limits, ir::NativeLanguage language) {
  using ir::NativeLanguage;
  const bool first = language == NativeLanguage::Vp1 || language == NativeLanguage::Vp11 ||
                     language == NativeLanguage::Vsp1;
  return language != NativeLanguage::None &&
         (limits.nvOptions != 0 || (first && limits.nvVertexProgram != 0));
}

/// ArbFragment or ArbVertex: the target that programs of that language are drawn with. Requires
/// another language than None.
[[nodiscard]] constexpr ir::Language stageOf(ir::NativeLanguage language) {
  return language == ir::NativeLanguage::Fp1 ? ir::Language::ArbFragment : ir::Language::ArbVertex;
}

} // namespace arbiter::fp
