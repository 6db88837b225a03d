#include "apps/tools/advise/cost.h"

#include <algorithm>
#include <tuple>

namespace arbiter::tools::advise {

Cost costOf(const fp::CheckResult &check) {
  const fp::ResourceCounts &counts = check.nativeCounts;
  // Under LimitPolicy::Report a program over a limit of the API only gets a warning.
  const bool over = std::any_of(
      check.diagnostics.begin(), check.diagnostics.end(),
      [](const fp::Diagnostic &each) { return std::string_view(each.id).starts_with("limit_"); });
  return {counts.aluInstructions, counts.texInstructions, counts.texIndirections,
          check.underNativeLimits && !over};
}

bool falls(const Cost &from, const Cost &to) {
  const bool grows = to.alu > from.alu || to.tex > from.tex || to.nodes > from.nodes;
  const bool less = to.alu < from.alu || to.tex < from.tex || to.nodes < from.nodes;
  return less && !grows && (to.fits || !from.fits);
}

bool fewerSlots(const Cost &from, const Cost &to) {
  return to.slots() < from.slots() && to.alu < from.alu && (to.fits || !from.fits);
}

bool cheaper(const Cost &a, const Cost &b) {
  return std::make_tuple(a.slots(), a.nodes) < std::make_tuple(b.slots(), b.nodes);
}

std::string changeText(const Cost &from, const Cost &to) {
  std::string text;
  const auto add = [&](const char *what, std::uint32_t old, std::uint32_t now) {
    if (old != now)
      text += (text.empty() ? "" : ", ") + std::string(what) + " " + std::to_string(old) + " -> " +
              std::to_string(now);
  };
  add("ALU", from.alu, to.alu);
  add("TEX", from.tex, to.tex);
  add("nodes", from.nodes, to.nodes);
  return text;
}

} // namespace arbiter::tools::advise
