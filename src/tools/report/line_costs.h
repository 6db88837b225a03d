#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/hw/native.h"
#include "tools/check/source_text.h"

/// A program's costs by the lines of its text.
namespace arbiter::tools {

/// What the instructions that begin in one line take together.
struct LineCost {
  std::uint32_t instructions = 0; ///< 0: the line begins none
  std::uint32_t gone = 0;         ///< of them, those of which nothing is left
  double slots = 0;
  std::uint32_t textures = 0;
  std::uint32_t firstNode = 0, lastNode = 0; ///< from 0; of the instructions that are not gone
};

/// The lines of instructions, each once, in ascending order. Numbers that are no instruction's are
/// left out.
[[nodiscard]] std::vector<std::uint32_t>
linesOfInstructions(const SourceText &source, const fp::ir::Program &program,
                    const std::vector<std::uint32_t> &instructions);

/// \returns one element a line, the first line first; empty where the report has no costs
[[nodiscard]] std::vector<LineCost> lineCosts(const SourceText &source,
                                              const fp::ir::Program &program,
                                              const fp::hw::NativeReport &report);

} // namespace arbiter::tools
