#include "state/programs/replacement.h"
#include "state/programs/variants/drop_variants.h"

#include "fp_compiler/file_programs.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/programs/program_load.h"
#include "state/programs/state_text.h"
#include "state/share/share_group.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Checks the target's program in a file, which may hold both programs of a material.
Replacement checked(Target target, std::string_view file, const fp::CompileOptions &options) {
  const fp::FileProgram program = fp::programOf(file, infoOf(target).language);
  return {std::string(program.in(file)), fp::checkProgramIn(file, program, options)};
}

/// Returns a client's text. It was checked when the client sent it.
std::optional<Replacement> findEdit(Target target, const std::string &name,
                                    const fp::CompileOptions &options) {
  std::string text;
  if (!ProgramEdits::instance().text(name, text))
    return std::nullopt;
  Replacement replacement = checked(target, text, options);
  if (!replacement.result.ok()) // a context with other limits may refuse it
    return std::nullopt;
  return replacement;
}

} // namespace

std::optional<Replacement> findReplacement(Target target, const Hash128 &hash,
                                           const fp::CompileOptions &options) {
  const std::string name = textFileName(target, hash);
  if (controlled())
    if (std::optional<Replacement> edit = findEdit(target, name, options))
      return edit;
  if (!ReplacementFolder::instance())
    return std::nullopt;
  ReplacementFolder &folder = *ReplacementFolder::instance();
  std::string file;
  if (!folder.read(name, file))
    return std::nullopt;
  const std::string path = folder.pathOf(name);
  if (hashBytes(file) == hash) { // unchanged since its capture: it replaces nothing
    folder.keepGood(name, {});
    return std::nullopt;
  }
  Replacement replacement = checked(target, file, options);
  if (replacement.result.ok()) {
    logInfo("state", "%s: loaded in place of the application's text", path.c_str());
    folder.keepGood(name, std::move(file));
    return replacement;
  }
  logText(LogLevel::Error, "state", path + " is not valid; the last text that was stays:",
          fp::renderAll(path, file, replacement.result.diagnostics));
  // Keeps the last valid text, for a program that is loaded again into another object.
  if (folder.lastGood(name, file))
    return checked(target, file, options);
  return replacement;
}

namespace {

void reload(ProgramContext &context, ProgramObject &object, const CompiledProgram &old) {
  const ProgramTarget &row = context.row(object.target);
  const auto replacement = findReplacement(object.target, old.hash, compileOptions(row));
  if (replacement && (!replacement->result.ok() || replacement->text == old.replacement))
    return;
  if (!replacement && !old.replaced())
    return;
  std::shared_ptr<const CompiledProgram> fresh;
  if (old.commands)
    fresh = compileFragmentShader(context, *old.commands);
  else
    fresh = compileProgram(context, object.target, old.text, compileText(context, row, old.text),
                           replacement ? &*replacement : nullptr);
  if (!fresh) {
    logError("state", "%s is gone and the application's own text is not valid; the last one stays",
             textFileName(object.target, old.hash).c_str());
    return;
  }
  if (!replacement)
    logInfo("state", "%s holds no other text: the application's own is back",
            textFileName(object.target, old.hash).c_str());
  context.group->setCompiled(object, std::move(fresh));
  if (row.bound.get() == &object)
    invalidateProgram(context);
  dropVariants(context, old);
}

/// Calls `see(object, compiled)` for each object with a program.
template <typename See> void forEachProgram(ProgramContext &context, See see) {
  for (const std::shared_ptr<ProgramObject> &object : context.group->objects())
    if (const std::shared_ptr<const CompiledProgram> old = context.group->compiledOf(*object))
      see(*object, *old);
}

void refreshFromFolder(ProgramContext &context, ReplacementFolder &folder) {
  folder.poll();
  const std::uint64_t now = folder.generation();
  if (context.group->replacementsSeen.load(std::memory_order_relaxed) == now)
    return;
  // One context of the group does the work; the others notice the changed objects.
  const std::uint64_t since = context.group->replacementsSeen.exchange(now);
  if (since == now)
    return;
  forEachProgram(context, [&](ProgramObject &object, const CompiledProgram &old) {
    if (folder.changedSince(textFileName(object.target, old.hash), since))
      reload(context, object, old);
  });
}

/// Takes over clients' changes. Each context does this itself, because each has its own held
/// values. What another context of the group has already compiled is not compiled again.
void refreshFromEdits(ProgramContext &context) {
  ProgramEdits &edits = ProgramEdits::instance();
  const std::uint64_t now = edits.generation();
  if (now == 0) [[likely]] // no client has ever changed anything
    return;
  const std::uint64_t since = edits.seenBy(context, now);
  if (since == now)
    return;
  for (ProgramTarget &row : context.targets) {
    ++row.envVersion; // makes values be collected anew
    context.attention |= row.parameterBits;
  }
  invalidateProgram(context); // a program may have been switched off
  forEachProgram(context, [&](ProgramObject &object, const CompiledProgram &old) {
    if (edits.changedSince(textFileName(object.target, old.hash), since))
      reload(context, object, old);
  });
}

} // namespace

void noteLoadedText(const ProgramObject &object, const Hash128 &hash) {
  ProgramEdits::instance().noteLoad(textFileName(object.target, hash));
}

void refreshReplacements(ProgramContext &context) {
  if (!replacing() || context.passThrough || context.listMode != 0)
    return;
  if (ReplacementFolder *const folder = ReplacementFolder::instance())
    refreshFromFolder(context, *folder);
  if (controlled())
    refreshFromEdits(context);
  if (context.stateTexts && context.stateTexts->changed())
    invalidateProgram(context);
}

} // namespace arbiter::state
