#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"
#include "fp_compiler/native_interface.h"

/// The compiler's facade. It takes program text, and gives checked IR, counts, diagnostics and
/// GLSL. No GL, no X11, no environment, no global state. Any thread may call it.
namespace arbiter::fp {

/// The treatment of a program over the API limits: Enforce refuses it, as the hardware's driver
/// would. Report loads it with a diagnostic.
enum class LimitPolicy : std::uint8_t { Enforce, Report };

struct CompileOptions {
  Limits limits;
  LimitPolicy policy = LimitPolicy::Enforce;
  Numerics numerics = Numerics::Host; ///< for register combiners, whose IR includes the rounding
};

/// The result of parse and check, before optimisation. The API's queries and `arbiter check` report
/// it.
struct CheckResult {
  std::vector<Diagnostic> diagnostics; ///< errors in text order, at most kMaxDiagnostics in all
  /// The checked program; empty if there is any error.
  std::optional<ir::Program> program;
  ResourceCounts counts;       ///< by the API's rules; zero if there is an error
  ResourceCounts nativeCounts; ///< for the profile's card (hw/native.h)
  bool underNativeLimits = false;
  NativeInterface native; ///< for a program in one of NVIDIA's languages; set if there is no error

  [[nodiscard]] bool ok() const { return program.has_value(); }
  /// Returns the byte offset of the first error, or -1 (GL_PROGRAM_ERROR_POSITION_ARB).
  [[nodiscard]] std::int32_t errorPosition() const;
  /// Returns all diagnostics as text, for GL_PROGRAM_ERROR_STRING_ARB; empty if there are none.
  [[nodiscard]] std::string errorString(std::string_view text) const;
};

/// Returns the language that the header names, even if its version is wrong. Returns nothing for
/// other texts.
[[nodiscard]] std::optional<ir::Language> languageOfText(std::string_view text);

/// Parses and checks a program. `options.limits` are those of the language's target. A text in one
/// of NVIDIA's languages is compiled by its header, whose target must be that of \p language. A
/// vertex state program belongs to ArbVertex.
[[nodiscard]] CheckResult checkProgram(ir::Language language, std::string_view text,
                                       const CompileOptions &options);
[[nodiscard]] CheckResult checkFragmentProgram(std::string_view text,
                                               const CompileOptions &options);

} // namespace arbiter::fp
