#pragma once
#include <cstdint>
#include <span>

namespace arbiter::fp {

/// The kind of a diagnostic: a row of diagnostic_ids.def.
enum class DiagnosticId : std::uint8_t {
#define FP_DIAGNOSTIC(Enumerator, id, meaning) Enumerator,
#include "fp_compiler/front/diagnostic_ids.def"
#undef FP_DIAGNOSTIC
};

/// A row of diagnostic_ids.def.
struct DiagnosticInfo {
  const char *id;      ///< "undeclared_name"
  const char *meaning; ///< one line
};

/// Returns the row of \p id.
[[nodiscard]] const DiagnosticInfo &info(DiagnosticId id);
/// Returns all rows, in the table's order.
[[nodiscard]] std::span<const DiagnosticInfo> diagnosticTable();

} // namespace arbiter::fp
