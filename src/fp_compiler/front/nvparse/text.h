#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/compiler.h"
#include "fp_compiler/front/words/names.h"
#include "fp_compiler/texture_shader/bind.h"
#include "fp_compiler/texture_shader/state.h"

/// Parses the texts of NVIDIA's library nvparse: register combiners (!!RC1.0) and texture shaders
/// (!!TS1.0). The result is the state that the API would have set. docs/write/register_combiners.md
/// and docs/write/texture_shaders.md have the grammar, and what is accepted beyond it.
namespace arbiter::fp::nvparse {

inline constexpr std::string_view kCombinerHeader = "!!RC1.0";
inline constexpr std::string_view kShaderHeader = "!!TS1.0";

/// The contents of a text: register combiners, texture shaders, or both.
struct Text {
  /// The textures are those with which the stages are consistent (assumedTextures()).
  std::optional<texture_shader::State> shaders;
  std::optional<combiners::State> combiners;
  /// Constant colours, matrices, scales and eye vectors that the text sets, by their env parameter.
  /// The application sets the others.
  texture_shader::Values values;
};

struct ParseResult {
  std::vector<Diagnostic> diagnostics; ///< in text order
  std::optional<Text> text;            ///< empty if there is any error
};

/// Parses and checks a text. Time is linear in the text. Memory is constant except for the
/// diagnostics, and there is no recursion. The limits are Limits::generalCombiners,
/// perStageConstants, textureShaders and textureUnits. LimitPolicy::Report accepts a text over one
/// of them.
/// \param language Combiners or TextureShaders, whose header is expected
/// \param names as in parseArbProgram(): registers are listed as temporaries or attributes,
/// constants as parameters
[[nodiscard]] ParseResult parse(ir::Language language, std::string_view text,
                                const CompileOptions &options, NameTable *names = nullptr);

/// Returns a text that parse() reads as this state and these values.
[[nodiscard]] std::string write(const Text &text);

/// Returns the formats with which most stages are consistent. A texture that a stage reads as an
/// offset is an offset texture, one read as HILO is a HILO texture, and all others are RGBA.
[[nodiscard]] std::array<texture_shader::Texture, texture_shader::kUnits>
assumedTextures(const texture_shader::State &state);

} // namespace arbiter::fp::nvparse
