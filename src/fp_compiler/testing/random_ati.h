#pragma once
#include <cstdint>
#include <string>

#include "fp_compiler/ati/shader.h"

/// Random ATI fragment shaders for property tests and for the differential suite: within the rules
/// of the text form and of the API form alike, from a seed, and the same on every machine.
namespace arbiter::fp::testing {

struct RandomAtiOptions {
  /// Image units that setups may sample, bit 0 = unit 0.
  std::uint8_t sampledUnits = 0x3F;
  /// No setup divides by a component of a register, and samples divide by texture coordinates' q
  /// alone, which inputs keep away from zero: what becomes of an infinity is the host's choice.
  bool tameDivisors = false;
  /// Nothing in the shader is undefined by the specification: registers are written before they are
  /// read, r0 is written, the factor of LERP is in [0,1], samples of units 2 and 3 (the scene's 3D
  /// and cube textures) do not divide.
  bool defined = false;
  /// Leaves out what Mesa 22.3.6 does against the specification: DOT2ADD's third argument, and
  /// alpha operations that read what the colour operation of their pair writes.
  bool peer = false;
  /// Dot products of alpha whose destination is not that of the colour operation: the API form
  /// alone can say that.
  bool separateDots = false;
};

/// A shader of one or two passes, each with setups and instructions.
[[nodiscard]] ati::Shader randomAtiShader(std::uint64_t seed, const RandomAtiOptions &options = {});

/// !!ATIfs1.0 text for a shader of randomAtiShader() without separate dots, with white space,
/// comments and masks varied by \p seed. Parsing it gives a shader of the same meaning.
[[nodiscard]] std::string spell(const ati::Shader &shader, std::uint64_t seed);

} // namespace arbiter::fp::testing
