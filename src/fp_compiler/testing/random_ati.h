#pragma once
#include <cstdint>
#include <string>

#include "fp_compiler/ati/shader.h"

/// Random ATI fragment shaders for property tests and for the differential suite. They obey the
/// rules of both the text form and the API form. A seed gives the same shader on every machine.
namespace arbiter::fp::testing {

struct RandomAtiOptions {
  /// Image units that setups may sample; bit 0 is unit 0.
  std::uint8_t sampledUnits = 0x3F;
  /// If set, no setup divides by a component of a register. Samples divide only by q of texture
  /// coordinates, which inputs keep away from zero. The host decides the result of an infinity.
  bool tameDivisors = false;
  /// If set, the specification defines everything in the shader. Registers are written before they
  /// are read, r0 is written, and the factor of LERP is in [0,1]. Samples of units 2 and 3 (the
  /// scene's 3D and cube textures) do not divide.
  bool defined = false;
  /// Leaves out where Mesa 22.3.6 violates the specification: DOT2ADD's third argument, and alpha
  /// operations that read what the colour operation of their pair writes.
  bool peer = false;
  /// Allows alpha dot products with another destination than the colour operation. Only the API
  /// form can express them.
  bool separateDots = false;
};

/// Returns a shader of one or two passes, each with setups and instructions.
[[nodiscard]] ati::Shader randomAtiShader(std::uint64_t seed, const RandomAtiOptions &options = {});

/// Returns !!ATIfs1.0 text for a shader of randomAtiShader() without separate dots. \p seed varies
/// white space, comments and masks. Parsing the text gives a shader with the same meaning.
[[nodiscard]] std::string spell(const ati::Shader &shader, std::uint64_t seed);

} // namespace arbiter::fp::testing
