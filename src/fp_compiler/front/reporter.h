#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"
#include "fp_compiler/front/diagnostic_ids.h"

namespace arbiter::fp {

/// Collects the front end's diagnostics, at most kMaxDiagnostics of each severity. Once it is full
/// of errors, the parser may stop.
class Reporter {
public:
  /// Adds a diagnostic, or drops it if its severity is full. \p message is one line without a full
  /// stop.
  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});
  void warning(DiagnosticId id, Span span, std::string message, std::string hint = {});

  [[nodiscard]] bool hasErrors() const { return m_errors != 0; }
  [[nodiscard]] std::size_t errorCount() const { return m_errors; }
  /// True if no further error would be kept.
  [[nodiscard]] bool full() const;

  /// Returns the diagnostics in text order, and removes them. Returns at most kMaxDiagnostics;
  /// errors take precedence.
  [[nodiscard]] std::vector<Diagnostic> take();

private:
  std::vector<Diagnostic> m_found;
  std::size_t m_errors = 0;
};

/// Returns a piece of the program in quotes, for a message. It is printable ASCII, and cut if it is
/// long.
[[nodiscard]] std::string quote(std::string_view piece);

} // namespace arbiter::fp
