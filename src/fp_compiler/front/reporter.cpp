#include "fp_compiler/front/reporter.h"

#include <algorithm>
#include <array>

#include "fp_compiler/limits.h"

namespace arbiter::fp {

namespace {
constexpr DiagnosticInfo kTable[] = {
#define FP_DIAGNOSTIC(Enumerator, id, meaning) {id, meaning},
#include "fp_compiler/front/diagnostic_ids.def"
#undef FP_DIAGNOSTIC
};
} // namespace

const DiagnosticInfo &info(DiagnosticId id) { return kTable[std::size_t(id)]; }

std::span<const DiagnosticInfo> diagnosticTable() { return kTable; }

void Reporter::error(DiagnosticId id, Span span, std::string message, std::string hint) {
  if (full())
    return;
  ++m_errors;
  m_found.push_back({Severity::Error, info(id).id, span, std::move(message), std::move(hint)});
}

void Reporter::warning(DiagnosticId id, Span span, std::string message, std::string hint) {
  if (m_found.size() - m_errors < kMaxDiagnostics)
    m_found.push_back({Severity::Warning, info(id).id, span, std::move(message), std::move(hint)});
}

bool Reporter::full() const { return m_errors >= kMaxDiagnostics; }

std::vector<Diagnostic> Reporter::take() {
  const auto isError = [](const Diagnostic &d) { return d.severity == Severity::Error; };
  std::stable_sort(m_found.begin(), m_found.end(), [](const Diagnostic &a, const Diagnostic &b) {
    return a.span.begin < b.span.begin;
  });
  if (m_found.size() > kMaxDiagnostics) {
    std::size_t room = kMaxDiagnostics - m_errors;
    std::erase_if(m_found, [&](const Diagnostic &d) {
      if (isError(d))
        return false;
      if (room == 0)
        return true;
      --room;
      return false;
    });
  }
  return std::move(m_found);
}

std::string quote(std::string_view piece) {
  constexpr std::size_t kShown = 48;
  std::string text = "'";
  for (char c : piece.substr(0, kShown))
    text += c >= ' ' && c <= '~' ? c : '?';
  text += piece.size() > kShown ? "...'" : "'";
  return text;
}

} // namespace arbiter::fp
