#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Programs made of a program, that show what lies inside it: drawn to float targets they give the
/// drawer's own values. None has a fog option.
namespace arbiter::tools::debug {

/// Draw buffers that one of these programs writes at most.
inline constexpr std::size_t kMostTargets = 4;

/// Which fragments such a program writes.
enum class Fragments {
  Covered,   ///< all of the mesh: there is no KIL, and depth is the fragment's own
  Surviving, ///< those that the program itself leaves, at the depths that it gives them: where
             ///< fragments lie over each other, the one that is seen
};

/// Whether the program has a say in it: KIL, or depths of its own.
[[nodiscard]] bool decidesFragments(const fp::ir::Program &program);

/// A place inside a program.
struct Probe {
  enum class Kind {
    Value,      ///< the destination register after the instruction; of KIL its operand
    Texel,      ///< a texture access's whole result
    Coordinate, ///< its operand
  } kind = Kind::Value;
  std::size_t row = 0;
};

/// The program up to the last of the probes, each of which goes to a colour of its own.
/// Requires: a fragment program; 1 to kMostTargets probes in the order of their rows.
[[nodiscard]] fp::ir::Program cutProgram(const fp::ir::Program &program,
                                         const std::vector<Probe> &probes,
                                         Fragments fragments = Fragments::Covered);

/// A program that writes operands (of the tables of \p program) to a colour each.
/// Requires: 1 to kMostTargets of them, attributes or parameters.
[[nodiscard]] fp::ir::Program showOperands(const fp::ir::Program &program,
                                           const std::vector<fp::ir::Operand> &operands,
                                           Fragments fragments = Fragments::Covered);

/// A program that samples at four coordinates, one a pixel of a 2x2 quad, so that its level of
/// detail is theirs. They are local parameters, so that every pixel is drawn with the same program:
/// 0 to 3 of the lower left, lower right, upper left, upper right pixel, with TXB's bias in w; 4 is
/// the middle of the quad in window pixels.
[[nodiscard]] fp::ir::Program sampleQuad(const fp::ir::Program &program, std::uint8_t unit,
                                         fp::ir::TexTarget target, bool biased);

} // namespace arbiter::tools::debug
