#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "apps/tools/advise/proposal.h"
#include "apps/tools/advise/subject.h"

/// Suggests improvements to a program, as an expert on the card would. Each suggestion lowers the
/// profile's counts. Each offered change gives the same results in the interpreter.
namespace arbiter::tools::advise {

/// A rule's identifier and title, for documentation and editors.
struct RuleInfo {
  const char *id;
  const char *title;
};
[[nodiscard]] std::vector<RuleInfo> ruleList();

struct Advice {
  const char *rule = "";
  fp::Span span;
  std::string message; ///< one line, no full stop
  Cost before, after;  ///< of the whole program
  /// The change of a fix. Empty for advice, because only the application can make its part.
  Edits edits;
  /// For advice: edits that show the changed program; they do not work without the application.
  Edits sketch;
  std::string application; ///< for advice: the application's part
  std::string condition;   ///< for advice: the condition under which the results are equal
  Nearness nearness = Nearness::Exact;

  [[nodiscard]] bool isFix() const { return !edits.empty(); }
};

/// Moves all spans by \p by bytes, from a program's text to the file that contains it.
void move(Advice &advice, std::uint32_t by);

/// Returns all suggestions in text order. Of alternatives for one place, keeps the one with the
/// largest gain. Empty for a text that does not load, for ATI's and nvparse's languages, and beyond
/// kMaxInstructions. Deterministic.
[[nodiscard]] std::vector<Advice> advise(std::string_view text, const Setting &setting);

/// The result of applying fixes one after the other, starting with the largest gain. After each fix
/// the new text is analyzed again.
struct Fixed {
  std::string text;
  std::vector<Advice> applied; ///< spans and edits refer to the text that each was applied to
  Cost before, after;
  bool stopped = false; ///< the search ended at its bound, and another one may find more
};

/// The bound of one search: instructions that its trials execute.
inline constexpr std::uint64_t kMaxStepsOfAll = 240'000'000;
[[nodiscard]] Fixed applyAll(std::string_view text, const Setting &setting,
                             std::uint64_t steps = kMaxStepsOfAll);

} // namespace arbiter::tools::advise
