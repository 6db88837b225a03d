#include "state/programs/state_texts.h"

#include <unordered_map>

#include "state/programs/program_context.h"
#include "state/programs/program_edits.h"
#include "state/programs/program_load.h"
#include "state/programs/replacement.h"
#include "state/report/capture.h"
#include "state/report/drawn_states.h"

namespace arbiter::state {

namespace {

std::uint64_t folderGeneration() {
  const ReplacementFolder *const folder = ReplacementFolder::instance();
  return folder ? folder->generation() : 0;
}

std::uint64_t editsGeneration() { return controlled() ? ProgramEdits::instance().generation() : 0; }

/// Tells clients of control about a state and its replacement.
void tellClients(Target target, const StateText &entry, const fp::CompileOptions &enforced) {
  fp::CompileOptions options = enforced;
  options.policy = fp::LimitPolicy::Report;
  const fp::CheckResult checked = fp::checkProgram(infoOf(target).language, entry.text, options);
  auto state = std::make_shared<CompiledProgram>();
  state->target = target;
  state->text = entry.text;
  state->hash = entry.hash;
  state->replacement = entry.replacement;
  state->counts = checked.counts;
  state->nativeCounts = checked.nativeCounts;
  state->underNativeLimits = checked.underNativeLimits;
  if (DrawnStates::instance().note(std::move(state)))
    ProgramEdits::instance().noteLoad(textFileName(target, entry.hash));
}

/// True if the replacement may have changed since it was looked up.
bool mayDiffer(Target target, const StateText &entry) {
  const std::string name = textFileName(target, entry.hash);
  return (entry.folderSeen != folderGeneration() &&
          ReplacementFolder::instance()->changedSince(name, entry.folderSeen)) ||
         (entry.editsSeen != editsGeneration() &&
          ProgramEdits::instance().changedSince(name, entry.editsSeen));
}

class KnownTexts final : public StateTexts {
public:
  const StateText &of(const ProgramContext &context, Target target,
                      const fp::nvparse::Text &state) override;
  void noteProgram(const ProgramContext &context, const StateText &text,
                   const CompiledProgram &compiled) override;
  bool changed() override;

private:
  static void look(const ProgramContext &context, Target target, StateText &entry);
  static void replace(Target target, StateText &entry, const fp::CompileOptions &options);

  static constexpr std::size_t kMax = 4096;
  std::unordered_map<std::string, std::unique_ptr<StateText>> m_texts;
  std::uint64_t m_folderSeen = 0, m_editsSeen = 0;
};

void KnownTexts::look(const ProgramContext &context, Target target, StateText &entry) {
  entry.folderSeen = folderGeneration();
  entry.editsSeen = editsGeneration();
  if (!replacing())
    return;
  const fp::CompileOptions options = compileOptions(context.row(target));
  replace(target, entry, options);
  if (controlled())
    tellClients(target, entry, options);
}

void KnownTexts::replace(Target target, StateText &entry, const fp::CompileOptions &options) {
  const std::optional<Replacement> found = findReplacement(target, entry.hash, options);
  if (!found) {
    entry.replacement.clear();
    entry.replaced.reset();
    return;
  }
  if (!found->result.ok() || found->text == entry.replacement)
    return; // keep the last replacement
  entry.replacement = found->text;
  entry.replaced = fp::nvparse::parse(infoOf(target).language, found->text, options).text;
}

const StateText &KnownTexts::of(const ProgramContext &context, Target target,
                                const fp::nvparse::Text &state) {
  std::string text = fp::nvparse::write(state);
  if (const auto it = m_texts.find(text); it != m_texts.end()) {
    if (mayDiffer(target, *it->second))
      look(context, target, *it->second);
    return *it->second;
  }
  if (m_texts.size() >= kMax)
    m_texts.clear();
  auto made = std::make_unique<StateText>();
  made->hash = hashBytes(text);
  made->text = text;
  look(context, target, *made);
  return *m_texts.emplace(std::move(text), std::move(made)).first->second;
}

bool KnownTexts::changed() {
  const std::uint64_t folder = folderGeneration(), edits = editsGeneration();
  const bool differs = folder != m_folderSeen || edits != m_editsSeen;
  m_folderSeen = folder;
  m_editsSeen = edits;
  return differs;
}

void KnownTexts::noteProgram(const ProgramContext &context, const StateText &text,
                             const CompiledProgram &compiled) {
  CaptureRecord *const record = CaptureRecord::instance();
  if (!record)
    return;
  const ProgramTarget &row = context.row(compiled.target);
  fp::CompileOptions options = compileOptions(row);
  options.policy = fp::LimitPolicy::Report;
  const fp::CheckResult result = fp::checkProgram(row.info().language, text.text, options);
  record->loaded(context.serial, compiled.target, text.text, result, result.errorString(text.text),
                 &compiled);
}

} // namespace

std::unique_ptr<StateTexts> makeStateTexts() {
  return capturing() || replacing() ? std::make_unique<KnownTexts>() : nullptr;
}

} // namespace arbiter::state
