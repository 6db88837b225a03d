#include <algorithm>
#include <map>

#include "apps/tools/language.h"
#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/native_text.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools::lsp {

namespace {

/// The cost of the instructions that end on one line.
struct LineCost {
  double slots = 0;
  std::uint32_t textures = 0;
  std::uint32_t node = 0;
  bool gone = true; ///< true if the compiler removed all of them
  std::vector<std::uint32_t> instructions;
};

Json hint(const View &view, std::uint32_t line, std::string label, std::string tooltip) {
  Json json = {{"position", view.document.map().position(view.document.map().line(line).end)},
               {"label", std::move(label)},
               {"paddingLeft", true}};
  if (!tooltip.empty())
    json["tooltip"] = std::move(tooltip);
  return json;
}

/// Returns "12/64 ALU instructions" for each resource of the target, with a mark if it is over its
/// limit.
Json total(const View &view) {
  const std::uint32_t header = view.document.map().lineOf(view.analysis.program.span.begin);
  if (const std::string_view lack = lackOf(view.analysis.limits, view.analysis.language);
      !lack.empty())
    return hint(view, header, view.profile.name + ": " + std::string(lack), {});
  const fp::ResourceCounts &counts = view.analysis.native.counts;
  const fp::ResourceCounts &limits = view.analysis.limits.native;
  std::string text = view.profile.name + ":";
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    if (!row.of(view.analysis.language))
      continue;
    const std::uint32_t used = counts.*row.member;
    const std::uint32_t limit = limits.*row.member;
    text += (text.back() == ':' ? " " : ", ") + std::to_string(used) + "/" + std::to_string(limit) +
            " " + row.title + (used > limit ? " (over)" : "");
  }
  const fp::hw::CycleEstimate &cycles = view.analysis.native.cycles;
  std::string tooltip = "used / native limit of " + view.profile.description;
  if (!cycles.bound.empty())
    tooltip += "\nthe " + cycles.bound + " unit decides the cycles; " + cycles.limits;
  return hint(view, header, std::move(text), std::move(tooltip));
}

/// Returns the reasons that name one of the instructions.
std::string reasonsOf(const View &view, const std::vector<std::uint32_t> &instructions) {
  std::string text;
  for (const fp::hw::Reason &reason : view.analysis.native.reasons) {
    const bool here =
        std::any_of(instructions.begin(), instructions.end(), [&](std::uint32_t instruction) {
          return std::binary_search(reason.instructions.begin(), reason.instructions.end(),
                                    instruction);
        });
    if (here && text.find(reason.text) == std::string::npos)
      text += (text.empty() ? "" : "\n") + reason.text;
  }
  return text;
}

std::string labelOf(const LineCost &cost, bool nodes) {
  if (cost.gone)
    return "gone";
  std::string text = costText(cost.slots, cost.textures);
  return nodes ? text + ", node " + std::to_string(cost.node + 1) : text;
}

} // namespace

Json inlayHints(const View &view, fp::Span span) {
  Json all = Json::array();
  const fp::CheckResult &check = view.analysis.inspection.check;
  if (!check.ok() || view.analysis.language == fp::ir::Language::AtiFragment ||
      isNvparse(view.analysis.language))
    return all;
  const TextMap &map = view.document.map();
  const std::uint32_t first = map.lineOf(span.begin);
  const std::uint32_t last = map.lineOf(span.end);
  const std::uint32_t header = map.lineOf(view.analysis.program.span.begin);
  if (first <= header && header <= last)
    all.push_back(total(view));
  const fp::hw::NativeReport &native = view.analysis.native;
  const auto &code = check.program->code;
  std::map<std::uint32_t, LineCost> lines;
  for (std::uint32_t i = 0; i < std::min(code.size(), native.costs.size()); ++i) {
    const std::uint32_t line = map.lineOf(code[i].span.end);
    if (line < first || line > last)
      continue;
    LineCost &cost = lines[line];
    cost.slots += native.costs[i].slots;
    cost.textures += native.costs[i].textures;
    cost.node = std::max(cost.node, native.costs[i].node);
    cost.gone = cost.gone && native.costs[i].gone;
    cost.instructions.push_back(i);
  }
  for (const auto &[line, cost] : lines)
    all.push_back(hint(view, line, labelOf(cost, native.nodes.size() > 1),
                       reasonsOf(view, cost.instructions)));
  return all;
}

} // namespace arbiter::tools::lsp
