#pragma once
#include <string_view>
#include <vector>

#include "fp_compiler/inspect.h"

/// Reads files that hold a program after comments, or several programs. Games of 2004 keep the
/// vertex and the fragment program of a material in one file. Their loaders look for a header, and
/// load the text from there to END. glProgramStringARB rejects such a file, because its header must
/// come first.
namespace arbiter::fp {

/// A program in a file.
struct FileProgram {
  ir::Language language = ir::Language::ArbFragment;
  Span span; ///< from its header up to the end of its END

  /// Returns the text that a loader gives to GL.
  [[nodiscard]] std::string_view in(std::string_view file) const {
    return file.substr(span.begin, span.end - span.begin);
  }
};

/// Returns the programs of a file, in text order; at least one. Only white space and comments (`#`
/// or C++) may come before the first header. Every further header begins a line. A program ends at
/// its END, at the next header, or at the end of the file. If a file begins with its only header,
/// or has no header, the whole file is one text.
[[nodiscard]] std::vector<FileProgram> programsOf(std::string_view file);

/// Returns the first program in the language, or else the whole file as a text in it.
[[nodiscard]] FileProgram programOf(std::string_view file, ir::Language language);

/// Checks one program of a file. All spans, and the position of the error, are places in the file.
/// It is a warning if the header of a file's only program is not its first byte: GL itself rejects
/// the file.
[[nodiscard]] CheckResult checkProgramIn(std::string_view file, const FileProgram &program,
                                         const CompileOptions &options);
/// Inspects one program of a file, with places in the file.
[[nodiscard]] Inspection inspectProgramIn(std::string_view file, const FileProgram &program,
                                          const CompileOptions &options);

} // namespace arbiter::fp
