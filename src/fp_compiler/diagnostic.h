#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/span.h"

namespace arbiter::fp {

enum class Severity : std::uint8_t { Error, Warning, Note };
/// Returns the severity's word in lines that editors read: "error", "warning", "note".
[[nodiscard]] const char *severityName(Severity severity);

/// A finding about a program string. `span.begin` of the first error is GL_PROGRAM_ERROR_POSITION.
/// For an error of the whole program it is the text's length (3.11.2).
struct Diagnostic {
  Severity severity = Severity::Error;
  const char *id = ""; ///< stable, kebab-case: "undeclared_name"; listed in docs
  Span span;
  std::string message; ///< one line, no full stop
  std::string hint;    ///< how to fix it; may be empty
};

/// A place in a text. Numbers start at 1; a column counts bytes. CR LF, LF and CR each end a line.
struct LineColumn {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};
/// Returns the place of byte \p offset in \p text, or the place after the last byte if it is
/// beyond.
[[nodiscard]] LineColumn locate(std::string_view text, std::uint32_t offset);

/// Returns "file:line:col: error: text [ID]", then the source line, a caret line and the hint.
[[nodiscard]] std::string render(std::string_view file, std::string_view text,
                                 const Diagnostic &diagnostic);
/// Returns only the first line of render().
[[nodiscard]] std::string renderLine(std::string_view file, std::string_view text,
                                     const Diagnostic &diagnostic);

/// Returns render() of all diagnostics. Takes linear time if they are in text order.
[[nodiscard]] std::string renderAll(std::string_view file, std::string_view text,
                                    const std::vector<Diagnostic> &diagnostics);

} // namespace arbiter::fp
