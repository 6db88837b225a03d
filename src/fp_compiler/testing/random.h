#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <string>

#include "fp_compiler/ir/ir.h"

/// Random programs for property tests and for the differential suite: valid, from a seed, and the
/// same on every machine.
namespace arbiter::fp::testing {

/// The distribution-free part of a generator, so that a seed means the same with every library.
class Random {
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}
  /// 0 <= result < count
  int below(int count) { return int(m_engine() % std::uint64_t(count)); }
  bool chance(int percent) { return below(100) < percent; }
  /// lo <= result < hi, on a grid of 1/1024 of the range
  float real(float lo, float hi) { return lo + (hi - lo) * float(below(1024)) / 1024.0f; }

private:
  std::mt19937_64 m_engine;
};

struct RandomOptions {
  int minInstructions = 2;
  int maxInstructions = 16;
  /// Special values, reads of unwritten registers, operands outside a function's domain. Without,
  /// nothing in the program is undefined by the specification and values stay moderate.
  bool wild = false;
  /// Reads of registers that nothing wrote, results written in part or not at all, and of vertices
  /// the position: each zero wherever the layer draws. Values stay moderate.
  bool unwritten = false;
  bool kills = true;
  bool options = true; ///< fog, shadow, draw buffers, coordinate conventions, hints
};

/// Image units of random programs and their targets: a program that samples unit u uses this one.
inline constexpr std::array<ir::TexTarget, 8> kUnitTargets = {
    ir::TexTarget::Tex2D,    ir::TexTarget::Tex1D,     ir::TexTarget::Tex3D,
    ir::TexTarget::Cube,     ir::TexTarget::Rect,      ir::TexTarget::Shadow2D,
    ir::TexTarget::Shadow1D, ir::TexTarget::ShadowRect};

/// Ranges that inputs must keep for a tame program's values to stay moderate.
struct InputRanges {
  static constexpr float kColorLow = 0.0f, kColorHigh = 1.0f;
  static constexpr float kTexCoordLow = -1.5f, kTexCoordHigh = 2.5f;   ///< s, t, r
  static constexpr float kTexCoordQLow = 0.5f, kTexCoordQHigh = 2.0f;  ///< q
  static constexpr float kParameterLow = -2.0f, kParameterHigh = 2.0f; ///< env, local, state
  static constexpr float kPositionHigh = 16.0f;                        ///< a 16 x 16 window
  static constexpr float kTexelLow = 0.0f, kTexelHigh = 1.0f;
};

/// A program that validate() accepts and that spell() can write.
[[nodiscard]] ir::Program randomProgram(std::uint64_t seed, const RandomOptions &options = {});

/// Likewise a vertex program. It leaves the vertex where it is (its position is the attribute's, or
/// ARB_position_invariant) and writes one or two results in full; wild ones also parts of others.
/// Rows that a tame program reads by address are rows that are there.
[[nodiscard]] ir::Program randomVertexProgram(std::uint64_t seed,
                                              const RandomOptions &options = {});

/// ARBfp1.0 or ARBvp1.0 text for a program of the functions above, with names, bindings, arrays,
/// aliases, comments, numerals and suffixes varied by \p seed. Parsing it gives a program of the
/// same meaning.
[[nodiscard]] std::string spell(const ir::Program &program, std::uint64_t seed);

} // namespace arbiter::fp::testing
