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

/// The compiler's facade: program text in, checked IR, counts, diagnostics and GLSL out. No GL, no
/// X11, no environment, no global state; safe to call from any thread.
namespace arbiter::fp {

/// Refuse a program over the API limits, as the hardware's driver would, or load it and say so.
enum class LimitPolicy : std::uint8_t { Enforce, Report };

struct CompileOptions {
  Limits limits;
  LimitPolicy policy = LimitPolicy::Enforce;
  Numerics numerics = Numerics::Host; ///< of register combiners, whose code has them in it
};

/// The result of parse and check (no optimisation): what the API's queries and `arbiter check` say.
struct CheckResult {
  std::vector<Diagnostic> diagnostics; ///< in text order of the errors, at most kMaxDiagnostics
  /// The checked program; empty if there is any error.
  std::optional<ir::Program> program;
  ResourceCounts counts;       ///< by the API's rules; zero if there is an error
  ResourceCounts nativeCounts; ///< of the profile's card (hw/native.h)
  bool underNativeLimits = false;
  NativeInterface native; ///< of a program in one of NVIDIA's languages, if there is no error

  [[nodiscard]] bool ok() const { return program.has_value(); }
  /// Byte offset of the first error, or -1 (GL_PROGRAM_ERROR_POSITION_ARB).
  [[nodiscard]] std::int32_t errorPosition() const;
  /// All diagnostics rendered, for GL_PROGRAM_ERROR_STRING_ARB; empty if there are none.
  [[nodiscard]] std::string errorString(std::string_view text) const;
};

/// The language that the header names, right or not in its version; none for any other text.
[[nodiscard]] std::optional<ir::Language> languageOfText(std::string_view text);

/// `options.limits` are those of the language's target. A text of NVIDIA's languages is compiled by
/// its header, whose target must be \p language's; a vertex state program is one of ArbVertex.
[[nodiscard]] CheckResult checkProgram(ir::Language language, std::string_view text,
                                       const CompileOptions &options);
[[nodiscard]] CheckResult checkFragmentProgram(std::string_view text,
                                               const CompileOptions &options);

} // namespace arbiter::fp
