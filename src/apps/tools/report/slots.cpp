#include "apps/tools/report/slots.h"

#include "apps/tools/language.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

std::vector<SlotHistogram> slotHistograms(const ProgramSet &set) {
  std::vector<SlotHistogram> histograms;
  for (const LanguageRow &language : languageRows()) {
    const fp::ResourceRow &row = fp::resourceRow(language.language == fp::ir::Language::ArbVertex
                                                     ? &fp::ResourceCounts::instructions
                                                     : &fp::ResourceCounts::aluInstructions);
    std::vector<std::uint32_t> amounts;
    for (const ReportedProgram &program : set.programs)
      if (program.file.counted() && program.file.language == language.language)
        amounts.push_back(program.file.result.nativeCounts.*row.member);
    if (amounts.empty())
      continue;
    const fp::Limits limits = limitsOf(set.profile, language.language);
    histograms.push_back({language.language, row.name,
                          std::string(row.title) + " of " + (language.header + 2) + " programs",
                          histogramOf(amounts, limits.native.*row.member)});
  }
  return histograms;
}

} // namespace arbiter::tools
