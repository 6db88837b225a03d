#include "apps/tools/report/line_costs.h"

#include <algorithm>
#include <limits>

namespace arbiter::tools {

std::vector<std::uint32_t> linesOfInstructions(const SourceText &source,
                                               const fp::ir::Program &program,
                                               const std::vector<std::uint32_t> &instructions) {
  std::vector<std::uint32_t> lines;
  for (const std::uint32_t i : instructions)
    if (i < program.code.size())
      lines.push_back(source.at(program.code[i].span.begin).line);
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

std::vector<LineCost> lineCosts(const SourceText &source, const fp::ir::Program &program,
                                const fp::hw::NativeReport &report) {
  std::vector<LineCost> lines;
  if (report.costs.empty())
    return lines;
  lines.resize(source.at(std::numeric_limits<std::uint32_t>::max()).line);
  for (std::size_t i = 0; i < std::min(program.code.size(), report.costs.size()); ++i) {
    const fp::hw::InstructionCost &cost = report.costs[i];
    LineCost &line = lines[source.at(program.code[i].span.begin).line - 1];
    ++line.instructions;
    line.slots += cost.slots;
    line.textures += cost.textures;
    if (cost.gone) {
      ++line.gone;
      continue;
    }
    const bool first = line.instructions - line.gone == 1;
    line.firstNode = first ? cost.node : std::min(line.firstNode, cost.node);
    line.lastNode = first ? cost.node : std::max(line.lastNode, cost.node);
  }
  return lines;
}

} // namespace arbiter::tools
