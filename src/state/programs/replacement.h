#pragma once
#include <optional>
#include <string>

#include "fp_compiler/compiler.h"
#include "state/objects/target.h"
#include "state/programs/program_edits.h"
#include "state/programs/replacement_folder.h"

/// Loads texts in place of the application's: those of a client of control, or else of
/// ARBITER_REPLACE. The application cannot tell: its queries return its own text and, if that is
/// valid, its own counts.
namespace arbiter::state {

struct ProgramContext;
struct ProgramObject;

/// The checked replacement of one text.
struct Replacement {
  std::string text;
  fp::CheckResult result;
};

/// True if ARBITER_REPLACE or ARBITER_CONTROL is set. It only loads a constant.
[[nodiscard]] inline bool replacing() {
  static const bool s_replacing = ReplacementFolder::instance() != nullptr || controlled();
  return s_replacing;
}

/// Returns the replacement of the text with that hash, or nothing. A text that is not valid is
/// logged with file, line, column and caret, and the last valid one is used instead, if there was
/// one.
[[nodiscard]] std::optional<Replacement> findReplacement(Target target, const Hash128 &hash,
                                                         const fp::CompileOptions &options);

/// Tells clients of control that a text was loaded into the object.
void noteLoadedText(const ProgramObject &object, const Hash128 &hash);

/// Takes over changes of files, and of clients of control, since the last call. The share group's
/// programs are compiled anew; they stay unchanged if a new text is not valid. It is cheap if
/// nothing changed. Requires that the context is current.
void refreshReplacements(ProgramContext &context);

} // namespace arbiter::state
