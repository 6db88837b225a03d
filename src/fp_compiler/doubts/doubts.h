#pragma once
#include <string_view>

#include "fp_compiler/file_programs.h"

/// Finds what a valid program says but hardly means. GL accepts such a program without a word, so
/// this is for the tools that an author uses, and not for GL's error string.
namespace arbiter::fp {

/// Adds warnings to the diagnostics of a valid program in the ARB languages or under NVIDIA's
/// options: temporaries that are read before they are written (unwritten_temporary), a result that
/// nothing writes (unwritten_result), and writes that nothing reads (unused_write). It is silent
/// where a branch or a condition leaves a doubt, and of programs in other languages.
/// \param result of checkProgramIn() or inspectProgramIn() for the same file and program
void addDoubts(std::string_view file, const FileProgram &program, CheckResult &result);

} // namespace arbiter::fp
