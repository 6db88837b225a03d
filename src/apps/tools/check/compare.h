#pragma once
#include <string>

#include "apps/tools/check/checked_file.h"
#include "apps/tools/check/terminal.h"

namespace arbiter::tools {

struct Side {
  CheckedFile file;
  const fp::hw::Profile *profile = nullptr;
};

/// Compares two programs under one profile, or one under two: the counts side by side, and B minus
/// A. Both sides must outlive the object.
class Comparison {
public:
  Comparison(const Side &a, const Side &b) : m_a(a), m_b(b) {}

  /// Returns both verdicts and a table. If a side has no counts, returns diagnostics in place of
  /// the table.
  [[nodiscard]] std::string text(const Style &style) const;
  /// Returns the JSON of both files and "compare".
  [[nodiscard]] std::string json() const;

private:
  [[nodiscard]] bool counted() const { return m_a.file.counted() && m_b.file.counted(); }

  const Side &m_a;
  const Side &m_b;
};

} // namespace arbiter::tools
