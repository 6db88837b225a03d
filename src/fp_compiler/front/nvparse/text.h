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

/// The texts that NVIDIA's library nvparse read: register combiners (!!RC1.0) and texture shaders
/// (!!TS1.0), as the state that the API would have set. docs/write/register_combiners.md and
/// docs/write/texture_shaders.md have the grammar, and what is taken here beside it.
namespace arbiter::fp::nvparse {

inline constexpr std::string_view kCombinerHeader = "!!RC1.0";
inline constexpr std::string_view kShaderHeader = "!!TS1.0";

/// What a text says: one of the two, or texture shaders with register combiners behind them.
struct Text {
  /// The textures are those that the stages need to be consistent (assumedTextures()).
  std::optional<texture_shader::State> shaders;
  std::optional<combiners::State> combiners;
  /// Constant colours, matrices, scales and eye vectors that the text gives, by their env
  /// parameter; what it does not give is the application's.
  texture_shader::Values values;
};

struct ParseResult {
  std::vector<Diagnostic> diagnostics; ///< in text order
  std::optional<Text> text;            ///< empty if there is any error
};

/// Parses and checks a text. Time is linear in the text, memory constant but for the diagnostics;
/// there is no recursion. The limits that count are Limits::generalCombiners, perStageConstants,
/// textureShaders and textureUnits; a text over one of them is right under LimitPolicy::Report.
/// \param language Combiners or TextureShaders, whose header is expected
/// \param names as of parseArbProgram(): registers and constants, under the kinds of temporaries,
///        attributes and parameters
[[nodiscard]] ParseResult parse(ir::Language language, std::string_view text,
                                const CompileOptions &options, NameTable *names = nullptr);

/// A text that parse() reads as the state, with the values.
[[nodiscard]] std::string write(const Text &text);

/// The formats with which most stages are consistent: what a stage reads as an offset is a texture
/// of offsets, what one reads as HILO a HILO texture, all else RGBA.
[[nodiscard]] std::array<texture_shader::Texture, texture_shader::kUnits>
assumedTextures(const texture_shader::State &state);

} // namespace arbiter::fp::nvparse
