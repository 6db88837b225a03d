#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "fp_compiler/ir/ir.h"

/// Random programs for property tests and for the differential suite. They are valid, and a seed
/// gives the same program on every machine.
namespace arbiter::fp::testing {

/// Random numbers without the library's distributions, so that a seed gives the same numbers
/// everywhere.
class Random {
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}
  /// Returns a number with 0 <= result < count.
  int below(int count) { return int(m_engine() % std::uint64_t(count)); }
  bool chance(int percent) { return below(100) < percent; }
  /// Returns a number with lo <= result < hi, on a grid of 1/1024 of the range.
  float real(float lo, float hi) { return lo + (hi - lo) * float(below(1024)) / 1024.0f; }

private:
  std::mt19937_64 m_engine;
};

struct RandomOptions {
  int minInstructions = 2;
  int maxInstructions = 16;
  /// Allows special values, reads of unwritten registers, and operands outside a function's domain.
  /// Without it, the specification defines everything in the program, and values stay moderate.
  bool wild = false;
  /// Allows reads of registers that nothing wrote, and results written in part or not at all, also
  /// a vertex's position. The layer makes each of them zero wherever it draws. Values stay
  /// moderate.
  bool unwritten = false;
  bool kills = true;
  bool options = true; ///< fog, shadow, draw buffers, coordinate conventions, hints
};

/// The target of each image unit that random programs sample.
inline constexpr std::array<ir::TexTarget, 8> kUnitTargets = {
    ir::TexTarget::Tex2D,    ir::TexTarget::Tex1D,     ir::TexTarget::Tex3D,
    ir::TexTarget::Cube,     ir::TexTarget::Rect,      ir::TexTarget::Shadow2D,
    ir::TexTarget::Shadow1D, ir::TexTarget::ShadowRect};

/// The ranges of inputs that keep a tame program's values moderate.
struct InputRanges {
  static constexpr float kColorLow = 0.0f, kColorHigh = 1.0f;
  static constexpr float kTexCoordLow = -1.5f, kTexCoordHigh = 2.5f;   ///< s, t, r
  static constexpr float kTexCoordQLow = 0.5f, kTexCoordQHigh = 2.0f;  ///< q
  static constexpr float kParameterLow = -2.0f, kParameterHigh = 2.0f; ///< env, local, state
  static constexpr float kPositionHigh = 16.0f;                        ///< a 16 x 16 window
  static constexpr float kTexelLow = 0.0f, kTexelHigh = 1.0f;
};

/// Returns a program that validate() accepts and that spell() can write.
[[nodiscard]] ir::Program randomProgram(std::uint64_t seed, const RandomOptions &options = {});

/// Returns a vertex program. It keeps the vertex where it is: it copies the position attribute, or
/// uses ARB_position_invariant. It writes one or two results in full; wild programs also write
/// parts of others. A tame program reads by address only rows that exist.
[[nodiscard]] ir::Program randomVertexProgram(std::uint64_t seed,
                                              const RandomOptions &options = {});

/// Returns ARBfp1.0 or ARBvp1.0 text for a program of these generators. \p seed varies names,
/// bindings, arrays, aliases, comments, numerals and suffixes. Parsing the text gives a program
/// with the same meaning.
[[nodiscard]] std::string spell(const ir::Program &program, std::uint64_t seed);

} // namespace arbiter::fp::testing
