#pragma once
#include <optional>
#include <string>

#include "fp_compiler/compiler.h"
#include "state/objects/target.h"
#include "state/programs/program_edits.h"
#include "state/programs/replacement_folder.h"

/// Texts that are loaded in place of the application's: a client's of control, or else those of
/// ARBITER_REPLACE. The application cannot tell: its queries answer its own text and, where that is
/// valid, its own counts.
namespace arbiter::state {

class Context;
struct ProgramObject;

/// What stands in for one text, checked.
struct Replacement {
  std::string text;
  fp::CheckResult result;
};

/// Whether ARBITER_REPLACE or ARBITER_CONTROL is set: one load of a constant.
[[nodiscard]] inline bool replacing() {
  static const bool s_replacing = ReplacementFolder::instance() != nullptr || controlled();
  return s_replacing;
}

/// The replacement of the text of that hash; nothing where there is none. One that is not valid is
/// reported in the log, with file, line, column and caret; the last one that was stands in for it,
/// if there was one.
[[nodiscard]] std::optional<Replacement> findReplacement(Target target, const Hash128 &hash,
                                                         const fp::CompileOptions &options);

/// A text was loaded into the object: clients of control are told.
void noteLoadedText(const ProgramObject &object, const Hash128 &hash);

/// Sees to files, and to what clients of control did, since the last call: the share group's
/// programs are compiled anew, and keep what they have where the new text is not valid. Cheap where
/// nothing changed. The context is current.
void refreshReplacements(Context &context);

} // namespace arbiter::state
