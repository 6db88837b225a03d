#include "tools/advise/advise.h"

#include <algorithm>

#include "tools/advise/rules/rules.h"
#include "tools/advise/trial.h"

namespace arbiter::tools::advise {

namespace {

/// Work that is spent on one program, in instructions run, about 60 to a microsecond. A long
/// program's proposals beyond are not tried.
constexpr std::uint64_t kMostSteps = 80'000'000, kMostStepsOfAll = 240'000'000;

/// What compiling a program is worth for each of its instructions; the R300's schedule grows with
/// the square.
std::uint64_t compileSteps(const Subject &subject) {
  constexpr std::uint64_t kEach = 640, kDoubling = 36;
  const bool schedules = subject.setting().limits.nativeModel == fp::NativeModel::R300 &&
                         subject.setting().language == fp::ir::Language::ArbFragment;
  return schedules ? kEach * (1 + subject.size() / kDoubling) : kEach;
}

/// Edits with the text that they make.
struct Rewrite {
  Edits edits;
  std::string text;
  fp::CheckResult check;
};

/// Compiles proposals and runs them.
class Judge {
public:
  Judge(const Subject &subject, std::uint64_t &steps) : m_subject(subject), m_steps(steps) {}

  /// The advice, if the proposal gains and is equal.
  std::optional<Advice> judge(const Proposal &proposal) {
    if (!spend(compileSteps(m_subject)))
      return std::nullopt;
    std::optional<Rewrite> rewrite = rewritten(proposal.edits);
    if (!rewrite)
      return std::nullopt;
    const Cost cost = costOf(rewrite->check);
    const bool gains =
        falls(m_subject.cost(), cost) || (proposal.texture && fewerSlots(m_subject.cost(), cost));
    if (!gains || !spend(2 * kTrials) || !holds(proposal, *rewrite->check.program))
      return std::nullopt;
    Advice advice;
    advice.rule = proposal.rule;
    advice.span = proposal.span;
    advice.message = proposal.message;
    advice.before = m_subject.cost();
    advice.after = cost;
    const bool fix = proposal.derived.empty() && proposal.condition.empty();
    (fix ? advice.edits : advice.sketch) = std::move(rewrite->edits);
    advice.application = proposal.application;
    advice.condition = proposal.condition;
    advice.nearness = proposal.nearness;
    return advice;
  }

private:
  /// A condition is the author's to know: it is not asked of made-up inputs.
  bool holds(const Proposal &proposal, const fp::ir::Program &program) const {
    return !proposal.condition.empty() ||
           equal(m_subject.program(), program, proposal.derived, proposal.nearness);
  }

  /// Takes what each instruction costs from what is left.
  bool spend(std::uint64_t each) {
    const std::uint64_t all = each * m_subject.size();
    const bool enough = all <= m_steps;
    m_steps -= enough ? all : m_steps;
    return enough;
  }

  [[nodiscard]] std::optional<Rewrite> checked(Edits edits) const {
    std::optional<std::string> text = applied(m_subject.text(), edits);
    if (!text)
      return std::nullopt;
    const Setting &setting = m_subject.setting();
    fp::CheckResult check =
        fp::checkProgram(setting.language, *text, {setting.limits, fp::LimitPolicy::Report});
    if (!check.ok())
      return std::nullopt;
    return Rewrite{std::move(edits), std::move(*text), std::move(check)};
  }

  /// The edits, and what they leave without a reader goes too.
  [[nodiscard]] std::optional<Rewrite> rewritten(const Edits &proposed) const {
    std::optional<Rewrite> rewrite = checked(proposed);
    if (!rewrite)
      return std::nullopt;
    const Edits more = leftOver(*rewrite);
    if (more.empty())
      return rewrite;
    Edits edits = proposed;
    edits.insert(edits.end(), more.begin(), more.end());
    sort(edits);
    return checked(std::move(edits));
  }

  /// Removals of statements that were live and are so no more.
  [[nodiscard]] Edits leftOver(const Rewrite &rewrite) const {
    const fp::ir::Program &program = *rewrite.check.program;
    const std::vector<std::uint8_t> written = fp::analysis::liveOf(program).written;
    Edits removals;
    for (std::size_t i = 0; i < program.code.size(); ++i) {
      if (written[i] != 0)
        continue;
      const auto begin = before(rewrite.edits, program.code[i].span.begin);
      const std::optional<std::uint32_t> old = begin ? instructionAt(*begin) : std::nullopt;
      if (old && m_subject.flow().live(*old))
        removals.push_back({wholeStatement(m_subject.text(), m_subject.at(*old).span), ""});
    }
    return removals;
  }

  [[nodiscard]] std::optional<std::uint32_t> instructionAt(std::uint32_t begin) const {
    for (std::uint32_t i = 0; i < m_subject.size(); ++i)
      if (m_subject.at(i).span.begin == begin)
        return i;
    return std::nullopt;
  }

  const Subject &m_subject;
  std::uint64_t &m_steps; ///< left
};

/// Two ways to change one place: the cheaper one stays, of equals the first. What the application
/// would have to do is said once of a place, whatever the rule.
void add(std::vector<Advice> &all, Advice &&advice) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const Advice &each) {
    const bool rule = std::string_view(each.rule) == advice.rule;
    const bool others = !each.application.empty() && !advice.application.empty();
    return each.span == advice.span && (rule || others);
  });
  if (same == all.end())
    all.push_back(std::move(advice));
  else if (cheaper(advice.after, same->after))
    *same = std::move(advice);
}

std::vector<Advice> adviceFor(const Subject &subject, std::uint64_t &steps) {
  std::vector<Advice> all;
  Judge judge(subject, steps);
  for (const Rule &rule : rules())
    for (Proposal &proposal : rule.propose(subject))
      if (std::optional<Advice> advice = judge.judge(proposal))
        add(all, std::move(*advice));
  std::stable_sort(all.begin(), all.end(),
                   [](const Advice &a, const Advice &b) { return a.span.begin < b.span.begin; });
  return all;
}

const Advice *bestFix(const std::vector<Advice> &all) {
  const Advice *best = nullptr;
  for (const Advice &each : all)
    if (each.isFix() && (best == nullptr || cheaper(each.after, best->after)))
      best = &each;
  return best;
}

} // namespace

std::vector<RuleInfo> ruleList() {
  std::vector<RuleInfo> list;
  for (const Rule &rule : rules())
    list.push_back({rule.id, rule.title});
  return list;
}

void move(Advice &advice, std::uint32_t by) {
  const auto moved = [by](fp::Span span) { return fp::Span{span.begin + by, span.end + by}; };
  advice.span = moved(advice.span);
  for (Edits *edits : {&advice.edits, &advice.sketch})
    for (Edit &edit : *edits)
      edit.span = moved(edit.span);
}

std::vector<Advice> advise(std::string_view text, const Setting &setting) {
  const std::unique_ptr<Subject> subject = Subject::read(text, setting);
  std::uint64_t steps = kMostSteps;
  return subject ? adviceFor(*subject, steps) : std::vector<Advice>();
}

Fixed applyAll(std::string_view text, const Setting &setting) {
  Fixed fixed;
  fixed.text = text;
  const std::unique_ptr<Subject> original = Subject::read(text, setting);
  if (!original)
    return fixed;
  fixed.before = fixed.after = original->cost();
  std::uint64_t left = kMostStepsOfAll;
  // Each fix makes a count smaller and none larger, so this ends.
  while (const std::unique_ptr<Subject> now = Subject::read(fixed.text, setting)) {
    std::uint64_t steps = std::min(left, kMostSteps);
    left -= steps;
    const std::vector<Advice> all = adviceFor(*now, steps);
    left += steps; // what was not needed
    const Advice *best = bestFix(all);
    std::optional<std::string> made = best ? applied(fixed.text, best->edits) : std::nullopt;
    const std::unique_ptr<Subject> next = made ? Subject::read(*made, setting) : nullptr;
    // Roundings add up: the whole way must be equal too.
    if (!next || !equal(original->program(), next->program(), {}, Nearness::Rounding))
      break;
    fixed.applied.push_back(*best);
    fixed.after = next->cost();
    fixed.text = std::move(*made);
  }
  return fixed;
}

} // namespace arbiter::tools::advise
