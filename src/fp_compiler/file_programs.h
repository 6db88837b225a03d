#pragma once
#include <string_view>
#include <vector>

#include "fp_compiler/inspect.h"

/// Files that hold a program behind comments, or several programs. Games of 2004 keep the vertex
/// and the fragment program of a material in one file; their loaders look for a header, and load
/// what stands from there to END. glProgramStringARB takes no such file: it wants the header first.
namespace arbiter::fp {

/// One program of a file.
struct FileProgram {
  ir::Language language = ir::Language::ArbFragment;
  Span span; ///< from its header to behind its END

  /// The text that a loader gives to GL.
  [[nodiscard]] std::string_view in(std::string_view file) const {
    return file.substr(span.begin, span.end - span.begin);
  }
};

/// The programs of a file, in text order; at least one. The first header has only white space and
/// comments (those of `#` and of C++) before it, every further one begins a line. A program reaches
/// to its END, or to the next header, or to the end of the file. A file that begins with its only
/// header, and one without a header, is one text as it stands.
[[nodiscard]] std::vector<FileProgram> programsOf(std::string_view file);

/// The first program of the language; where there is none, the whole file as a text of it.
[[nodiscard]] FileProgram programOf(std::string_view file, ir::Language language);

/// checkProgram() of one program of a file. All spans, and the position of the error, are places in
/// the file. A header that is not the first byte of a file with one program is a warning: GL itself
/// refuses the file.
[[nodiscard]] CheckResult checkProgramIn(std::string_view file, const FileProgram &program,
                                         const CompileOptions &options);
/// inspectProgram(), likewise.
[[nodiscard]] Inspection inspectProgramIn(std::string_view file, const FileProgram &program,
                                          const CompileOptions &options);

} // namespace arbiter::fp
