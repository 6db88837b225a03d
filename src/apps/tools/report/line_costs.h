#pragma once
#include <cstdint>
#include <vector>

#include "apps/tools/check/source_text.h"
#include "fp_compiler/hw/native.h"

/// Sums a program's costs for each line of its text.
namespace arbiter::tools {

/// The total cost of the instructions that begin on one line.
struct LineCost {
  std::uint32_t instructions = 0; ///< 0: no instruction begins on the line
  std::uint32_t gone = 0;         ///< instructions that the compiler removed entirely
  double slots = 0;
  std::uint32_t textures = 0;
  std::uint32_t firstNode = 0, lastNode = 0; ///< from 0, without removed instructions
};

/// Returns the lines of instructions, each once, in ascending order. Ignores numbers of missing
/// instructions.
[[nodiscard]] std::vector<std::uint32_t>
linesOfInstructions(const SourceText &source, const fp::ir::Program &program,
                    const std::vector<std::uint32_t> &instructions);

/// Returns one element for each line; empty if the report has no costs.
[[nodiscard]] std::vector<LineCost> lineCosts(const SourceText &source,
                                              const fp::ir::Program &program,
                                              const fp::hw::NativeReport &report);

} // namespace arbiter::tools
