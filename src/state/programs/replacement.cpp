#include "state/programs/replacement.h"
#include "state/host_draw/variants/drop_variants.h"

#include "state/core/context.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_load.h"
#include "state/share/share_group.h"
#include "util/log.h"

namespace arbiter::state {

std::optional<Replacement> findReplacement(Target target, const Hash128 &hash,
                                           const fp::CompileOptions &options) {
  ReplacementFolder &folder = *ReplacementFolder::instance();
  const std::string name = textFileName(target, hash);
  Replacement replacement;
  if (!folder.read(name, replacement.text))
    return std::nullopt;
  const std::string path = folder.pathOf(name);
  const auto check = [&] {
    replacement.result = fp::checkProgram(infoOf(target).language, replacement.text, options);
    return replacement.result.ok();
  };
  if (hashBytes(replacement.text) == hash) { // as it was captured: it replaces nothing
    folder.keepGood(name, {});
    return std::nullopt;
  }
  if (check()) {
    logInfo("state", "%s: loaded in place of the application's text", path.c_str());
    folder.keepGood(name, replacement.text);
    return replacement;
  }
  logText(LogLevel::Error, "state", path + " is not valid; the last text that was stays:",
          fp::renderAll(path, replacement.text, replacement.result.diagnostics));
  // For a program that is loaded again, in an object of its own.
  if (folder.lastGood(name, replacement.text))
    static_cast<void>(check());
  return replacement;
}

namespace {

void reload(Context &context, ProgramObject &object, std::uint64_t since) {
  const std::shared_ptr<const CompiledProgram> old = context.group->compiledOf(object);
  if (!old ||
      !ReplacementFolder::instance()->changedSince(textFileName(object.target, old->hash), since))
    return;
  const ProgramTarget &row = context.row(object.target);
  const auto replacement = findReplacement(object.target, old->hash, compileOptions(row));
  if (replacement && (!replacement->result.ok() || replacement->text == old->replacement))
    return;
  const fp::Compilation own = compileText(context, row, old->text);
  std::shared_ptr<const CompiledProgram> fresh =
      compileProgram(context, object.target, old->text, own, replacement ? &*replacement : nullptr);
  if (!fresh) {
    logError("state", "%s is gone and the application's own text is not valid; the last one stays",
             textFileName(object.target, old->hash).c_str());
    return;
  }
  if (!replacement)
    logInfo("state", "%s holds no other text: the application's own is back",
            textFileName(object.target, old->hash).c_str());
  context.group->setCompiled(object, std::move(fresh));
  if (row.bound.get() == &object)
    invalidateProgram(context);
  dropVariants(context, *old);
}

} // namespace

void refreshReplacements(Context &context) {
  if (!replacing() || context.passThrough || context.listMode != 0)
    return;
  ReplacementFolder &folder = *ReplacementFolder::instance();
  folder.poll();
  const std::uint64_t now = folder.generation();
  if (context.group->replacementsSeen.load(std::memory_order_relaxed) == now)
    return;
  // One context of the group does the work; the others see that the objects changed.
  const std::uint64_t since = context.group->replacementsSeen.exchange(now);
  if (since == now)
    return;
  for (const std::shared_ptr<ProgramObject> &object : context.group->objects())
    reload(context, *object, since);
}

} // namespace arbiter::state
