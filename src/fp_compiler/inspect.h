#pragma once
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/words/names.h"

/// Checks a program for an editor: finds every name, also in texts that are not complete.
namespace arbiter::fp {

struct Inspection {
  CheckResult check;
  NameTable names; ///< refers to the text
};

/// Checks a program and finds the names of its text. If the header is wrong or missing, the rest of
/// the text is checked too, so that there are diagnostics and names for it. The check still fails.
/// `text` must outlive the result.
[[nodiscard]] Inspection inspectProgram(ir::Language language, std::string_view text,
                                        const CompileOptions &options);

} // namespace arbiter::fp
