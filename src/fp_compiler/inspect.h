#pragma once
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/words/names.h"

/// A program's check as an editor wants it: with every name, and of texts that are not whole yet.
namespace arbiter::fp {

struct Inspection {
  CheckResult check;
  NameTable names; ///< views the text
};

/// checkProgram(), and the names of the text. Where the header is wrong or missing the text behind
/// it is looked at all the same, so that there are diagnostics and names of what is written so far;
/// the check is no better for that. `text` must outlive the result.
[[nodiscard]] Inspection inspectProgram(ir::Language language, std::string_view text,
                                        const CompileOptions &options);

} // namespace arbiter::fp
