#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"
#include "fp_compiler/front/diagnostic_ids.h"

namespace arbiter::fp {

/// Collects what the front end finds. Holds at most kMaxDiagnostics of each severity; once it is
/// full of errors, the parser may stop.
class Reporter {
public:
  /// Adds a finding; dropped where its severity is full. \p message is one line, no full stop.
  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});
  void warning(DiagnosticId id, Span span, std::string message, std::string hint = {});

  [[nodiscard]] bool hasErrors() const { return m_errors != 0; }
  [[nodiscard]] std::size_t errorCount() const { return m_errors; }
  /// No further error would be kept.
  [[nodiscard]] bool full() const;

  /// The findings, which are gone from here then: in text order, at most kMaxDiagnostics, of which
  /// errors have precedence.
  [[nodiscard]] std::vector<Diagnostic> take();

private:
  std::vector<Diagnostic> m_found;
  std::size_t m_errors = 0;
};

/// A piece of the program in quotes, for a message: printable ASCII only, and cut short.
[[nodiscard]] std::string quote(std::string_view piece);

} // namespace arbiter::fp
