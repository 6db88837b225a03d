#pragma once
#include <string>
#include <vector>

#include "apps/tools/report/histogram.h"
#include "apps/tools/report/program_set.h"

namespace arbiter::tools {

/// The histogram of one language's native slots: ALU slots of fragment programs, instructions of
/// vertex programs.
struct SlotHistogram {
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  const char *resource = ""; ///< the name in a profile: "alu_instructions"
  std::string what;          ///< "ALU instructions of ARBfp1.0 programs"
  Histogram histogram;
};

/// Returns one histogram for each language that has programs with counts.
[[nodiscard]] std::vector<SlotHistogram> slotHistograms(const ProgramSet &set);

} // namespace arbiter::tools
