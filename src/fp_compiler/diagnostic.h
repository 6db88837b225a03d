#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

namespace arbiter::fp {

enum class Severity : std::uint8_t { Error, Warning, Note };
/// The word for it in lines that editors read: "error", "warning", "note".
[[nodiscard]] const char *severityName(Severity severity);

/// One finding about a program string. `span.begin` of the first error is GL_PROGRAM_ERROR_POSITION
/// (the text's length for an error of the whole program, 3.11.2).
struct Diagnostic {
  Severity severity = Severity::Error;
  const char *id = ""; ///< stable, kebab-case: "undeclared-name"; listed in docs
  Span span;
  std::string message; ///< one line, no full stop
  std::string hint;    ///< what to do about it; may be empty
};

/// 1-based; a column counts bytes. CR LF, LF and CR each end a line.
struct LineColumn {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};
/// Where byte \p offset of \p text stands; the place after the last byte if it is beyond.
[[nodiscard]] LineColumn locate(std::string_view text, std::uint32_t offset);

/// "file:line:col: error: text [ID]", then the source line, a caret line and the hint.
[[nodiscard]] std::string render(std::string_view file, std::string_view text,
                                 const Diagnostic &diagnostic);
/// The first line of render() alone.
[[nodiscard]] std::string renderLine(std::string_view file, std::string_view text,
                                     const Diagnostic &diagnostic);

/// render() of each, one after another; linear in the text if they are in text order.
[[nodiscard]] std::string renderAll(std::string_view file, std::string_view text,
                                    const std::vector<Diagnostic> &diagnostics);

} // namespace arbiter::fp
