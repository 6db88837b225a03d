#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/ir/interface.h"

/// Hints for authors who know GLSL, Cg, HLSL or C: what a name, a statement or an operator of
/// theirs is in the assembly languages.
namespace arbiter::fp::c_like {

/// The languages whose forms differ; the columns of names.def.
enum class Dialect { Fragment, Vertex, OwnFragment, OwnVertex, Ati, Combiners };
inline constexpr int kDialectCount = 6;

/// Statements of C; the rows C_FORM of names.def.
enum class Form {
#define C_NAME(name, of, ...)
#define C_FORM(Kind, ...) Kind,
#include "fp_compiler/front/c_like/names.def"
};

/// Returns the column of a program in one of the ARB languages.
[[nodiscard]] constexpr Dialect dialectOf(ir::Language language) {
  return language == ir::Language::ArbVertex ? Dialect::Vertex : Dialect::Fragment;
}

/// Returns "gl_FragColor is GLSL's; the assembly writes result.color". Empty for a name that
/// names.def does not have.
[[nodiscard]] std::string nameHint(std::string_view name, Dialect dialect);

/// Returns the register that stands for such a name, "result.color"; empty if there is none.
[[nodiscard]] std::string registerOf(std::string_view name, Dialect dialect);

/// Returns components as a suffix of four: "xyzz" of "xyz", "xyyy" of "st". Empty if a letter is
/// none of GLSL's or there are more than four. One component stays one.
[[nodiscard]] std::string fourComponents(std::string_view suffix);

/// Returns what stands in place of a statement, with its name and value.
[[nodiscard]] std::string formHint(Form form, Dialect dialect, std::string_view name = {},
                                   std::string_view value = {});

} // namespace arbiter::fp::c_like
