#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fp_compiler/compiler.h"

/// Compiles a program string to one value, and converts that value to bytes for a cache. No GL, no
/// files.
namespace arbiter::fp {

/// The result for a program string: the checked program or its diagnostics, and its GLSL.
struct Compilation {
  /// A program with loops is already optimised. Code generators run the passes again and find
  /// little to do.
  CheckResult check;
  /// Empty if the check failed, and for vertex state programs, which draw nothing. Also empty for
  /// ATI's languages, whose GLSL depends on the state at the draw (fixed_function.h).
  GlslShader glsl;
};

/// Everything besides the compiler that a compilation depends on.
struct CompilationInput {
  ir::Language language = ir::Language::ArbFragment;
  CompileOptions options;
  GlslHost host;
  Numerics numerics = Numerics::Host; ///< for the emitted GLSL
};

/// Checks the program and, if that succeeds and the language allows it, emits GLSL.
[[nodiscard]] Compilation compile(const CompilationInput &input, std::string_view text);

/// Returns all that decides the result, as bytes: equal for equal inputs, different for different
/// ones.
[[nodiscard]] std::string cacheKey(const CompilationInput &input, std::string_view text);

/// Returns the result as bytes. Only deserialise() of the same build of the compiler reads them.
[[nodiscard]] std::string serialise(const Compilation &compilation);
/// Reads the bytes that serialise() wrote. Returns nothing for any other bytes, or if
/// ir::validate() rejects the program. Safe for any bytes.
[[nodiscard]] std::optional<Compilation> deserialise(std::string_view bytes);

} // namespace arbiter::fp
