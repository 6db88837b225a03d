#pragma once
#include <string>

#include "tools/check/checked_file.h"
#include "tools/check/terminal.h"

namespace arbiter::tools {

struct Side {
  CheckedFile file;
  const fp::hw::Profile *profile = nullptr;
};

/// Two programs under one profile, or one under two: counts side by side, and B less A. Both sides
/// must outlive it.
class Comparison {
public:
  Comparison(const Side &a, const Side &b) : m_a(a), m_b(b) {}

  /// Both verdicts, then a table; diagnostics in its place where a side has no counts.
  [[nodiscard]] std::string text(const Style &style) const;
  /// As for files checked one by one, and "compare".
  [[nodiscard]] std::string json() const;

private:
  [[nodiscard]] bool counted() const { return m_a.file.counted() && m_b.file.counted(); }

  const Side &m_a;
  const Side &m_b;
};

} // namespace arbiter::tools
