#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fp_compiler/compiler.h"

/// A program string's whole way through the compiler as one value, and that value as bytes, for a
/// cache. No GL, no files.
namespace arbiter::fp {

/// What came of a program string: the checked program or its diagnostics, and its GLSL.
struct Compilation {
  /// A program with loops is there as the passes left it: what makes code of it runs them again,
  /// and finds little to do.
  CheckResult check;
  /// Empty where the check failed, for ATI's languages, whose GLSL depends on the state that they
  /// are drawn under (fixed_function.h), and for vertex state programs, which draw nothing.
  GlslShader glsl;
};

/// What a compilation depends on, beside the compiler itself.
struct CompilationInput {
  ir::Language language = ir::Language::ArbFragment;
  CompileOptions options;
  GlslHost host;
  Numerics numerics = Numerics::Host; ///< of the emitted GLSL
};

/// checkProgram() and, if that went well and the language allows, emitGlsl().
[[nodiscard]] Compilation compile(const CompilationInput &input, std::string_view text);

/// All that decides the result, as bytes: equal for equal inputs, different for different ones.
[[nodiscard]] std::string cacheKey(const CompilationInput &input, std::string_view text);

/// The result as bytes, which only deserialise() of the same build of the compiler reads.
[[nodiscard]] std::string serialise(const Compilation &compilation);
/// Nothing if the bytes are not, to the last, what serialise() wrote, or hold a program that
/// ir::validate() does not accept. Safe for any bytes.
[[nodiscard]] std::optional<Compilation> deserialise(std::string_view bytes);

} // namespace arbiter::fp
