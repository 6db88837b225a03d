#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tools/advise/proposal.h"
#include "tools/advise/subject.h"

/// What a person who knows the card would say about a program. Nothing is said that does not make
/// the profile's count fall, and no change is offered whose results in the interpreter are not
/// those of the program as it is.
namespace arbiter::tools::advise {

/// A rule, as documentation and editors list them.
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
  /// Of a fix: the change. Of advice empty, as only the application can do its part.
  Edits edits;
  /// Of advice: what the program would be then, as edits; they do not stand by themselves.
  Edits sketch;
  std::string application; ///< of advice: what the application would do
  std::string condition;   ///< of advice: what must hold for the sketch to be equal
  Nearness nearness = Nearness::Exact;

  [[nodiscard]] bool isFix() const { return !edits.empty(); }
};

/// Every place becomes one of a longer text, which has the program from byte \p by on.
void move(Advice &advice, std::uint32_t by);

/// In text order; of several ways to say one thing, the one that gains most. Empty for a text that
/// does not load, for ATI's language, and beyond kMaxInstructions. Deterministic.
[[nodiscard]] std::vector<Advice> advise(std::string_view text, const Setting &setting);

/// One fix after the other, the one that gains most first, each looked for and tried anew in the
/// text that the one before left.
struct Fixed {
  std::string text;
  std::vector<Advice> applied; ///< spans and edits are of the text that each met
  Cost before, after;
};
[[nodiscard]] Fixed applyAll(std::string_view text, const Setting &setting);

} // namespace arbiter::tools::advise
