#include "apps/tools/advise/advise.h"

#include <algorithm>

#include "apps/tools/advise/rules/rules.h"
#include "apps/tools/advise/trial.h"

namespace arbiter::tools::advise {

namespace {

/// Limits of work for one program and for all of applyAll(), in executed instructions (about 60 per
/// microsecond). Further proposals are not tested.
constexpr std::uint64_t kMaxSteps = 80'000'000;

/// Returns the estimated cost of compiling for each instruction. Scheduling for the R300 takes
/// quadratic time.
std::uint64_t compileSteps(const Subject &subject) {
  constexpr std::uint64_t kEach = 640, kDoubling = 36;
  const bool schedules = subject.setting().limits.nativeModel == fp::NativeModel::R300 &&
                         subject.setting().language == fp::ir::Language::ArbFragment;
  return schedules ? kEach * (1 + subject.size() / kDoubling) : kEach;
}

/// Edits, and the resulting text.
struct Rewrite {
  Edits edits;
  std::string text;
  fp::CheckResult check;
};

/// Compiles and tests proposals.
class Judge {
public:
  Judge(const Subject &subject, std::uint64_t &steps) : m_subject(subject), m_steps(steps) {}

  /// Returns the suggestion if the proposal lowers the cost and keeps the results.
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
  /// True if the results are equal. Generated inputs cannot test a condition that only the author
  /// knows.
  bool holds(const Proposal &proposal, const fp::ir::Program &program) const {
    return !proposal.condition.empty() ||
           equal(m_subject.program(), program, proposal.derived, proposal.nearness);
  }

  /// Subtracts a cost for each instruction from the remaining steps; false if they do not suffice.
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

  /// Applies the edits, and removes statements that then have no reader.
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

  /// Returns edits that remove statements which the rewrite made dead.
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
  std::uint64_t &m_steps; ///< remaining steps
};

/// Adds a suggestion. For the same rule and span only the cheaper one is kept, or the first of
/// equals. Suggestions for the application are kept once per span, for any rules.
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
  std::uint64_t steps = kMaxSteps;
  return subject ? adviceFor(*subject, steps) : std::vector<Advice>();
}

Fixed applyAll(std::string_view text, const Setting &setting, std::uint64_t left) {
  Fixed fixed;
  fixed.text = text;
  const std::unique_ptr<Subject> original = Subject::read(text, setting);
  if (!original)
    return fixed;
  fixed.before = fixed.after = original->cost();
  // The loop ends because each fix lowers a count and raises none.
  while (const std::unique_ptr<Subject> now = Subject::read(fixed.text, setting)) {
    std::uint64_t steps = std::min(left, kMaxSteps);
    left -= steps;
    const std::vector<Advice> all = adviceFor(*now, steps);
    fixed.stopped = steps == 0;
    left += steps; // give back the unused steps
    const Advice *best = bestFix(all);
    std::optional<std::string> made = best ? applied(fixed.text, best->edits) : std::nullopt;
    const std::unique_ptr<Subject> next = made ? Subject::read(*made, setting) : nullptr;
    // Rounding errors add up, so that the total change is tested too.
    if (!next || !equal(original->program(), next->program(), {}, Nearness::Rounding))
      break;
    fixed.applied.push_back(*best);
    fixed.after = next->cost();
    fixed.text = std::move(*made);
  }
  return fixed;
}

} // namespace arbiter::tools::advise
