#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "apps/tools/ir_names.h"

/// Makes programs that show values inside another program. Drawn to float targets, they return the
/// drawer's own values. None of them has a fog option.
namespace arbiter::tools::debug {

/// The maximum of draw buffers that one of these programs writes.
inline constexpr std::size_t kMaxTargets = 4;

/// The fragments that such a program writes.
enum class Fragments {
  Covered,   ///< all of the mesh: without KIL, at the rasterized depth
  Surviving, ///< those that the original program keeps, at its depths; of overlapping fragments,
             ///< the visible one
};

/// True if the program decides which fragments are visible, by KIL or by its own depths.
[[nodiscard]] bool decidesFragments(const fp::ir::Program &program);

/// True if the program writes result.depth.
[[nodiscard]] bool writesDepth(const fp::ir::Program &program);

/// Returns the program with all its results but result.depth, so that its fragments are at the
/// rasterized depth. Requires: a fragment program.
[[nodiscard]] fp::ir::Program withoutDepth(const fp::ir::Program &program);

/// A value inside a program.
struct Probe {
  enum class Kind {
    Value,      ///< the destination register after the instruction; KIL's operand
    Texel,      ///< the whole result of a texture access
    Coordinate, ///< the coordinate of a texture access
  } kind = Kind::Value;
  std::size_t row = 0;
};

/// Returns the program up to the last probe; each probe is written to its own color.
/// Requires: a fragment program; 1 to kMaxTargets probes in the order of their rows.
[[nodiscard]] fp::ir::Program cutProgram(const fp::ir::Program &program,
                                         const std::vector<Probe> &probes,
                                         Fragments fragments = Fragments::Covered);

/// Returns a program that writes each operand to its own color.
/// Requires: 1 to kMaxTargets attributes or parameters in the tables of \p program.
[[nodiscard]] fp::ir::Program showOperands(const fp::ir::Program &program,
                                           const std::vector<fp::ir::Operand> &operands,
                                           Fragments fragments = Fragments::Covered);

/// Returns a program that samples at four coordinates, one per pixel of a 2x2 quad, so that they
/// determine the level of detail. Coordinates are local parameters, so that all pixels use the same
/// program. Parameters 0 to 3 belong to the lower left, lower right, upper left and upper right
/// pixel, with TXB's bias in w. Parameter 4 is the middle of the quad in window pixels.
[[nodiscard]] fp::ir::Program sampleQuad(const fp::ir::Program &program, std::uint8_t unit,
                                         fp::ir::TexTarget target, bool biased);

} // namespace arbiter::tools::debug
