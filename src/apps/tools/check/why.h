#pragma once
#include <string>

#include "apps/tools/check/checked_file.h"
#include "apps/tools/check/source_text.h"
#include "apps/tools/check/terminal.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

/// Formats a NativeReport as text with positions in the source. A missing part of the report is an
/// empty text. Requires a file that is counted() and outlives the object.
class Why {
public:
  /// \param all shows every reason with every instruction, not only the largest
  Why(const CheckedFile &file, const Style &style, bool all);

  /// Returns the reasons for one resource's count, the largest first.
  [[nodiscard]] std::string reasons(const fp::ResourceRow &row) const;
  /// Returns one line: the model, nodes, dependent reads, cycles.
  [[nodiscard]] std::string headline() const;
  /// Returns the longest chain of dependent reads, one instruction per line.
  [[nodiscard]] std::string chain() const;
  /// Returns the texture nodes, each with its samples and the reason for its start.
  [[nodiscard]] std::string nodes() const;
  /// Returns the estimated cycles by unit, and what the estimate ignores.
  [[nodiscard]] std::string cycles() const;
  /// Returns the cost of each instruction.
  [[nodiscard]] std::string costs() const;

private:
  [[nodiscard]] std::string lines(const std::vector<std::uint32_t> &instructions) const;
  [[nodiscard]] std::string place(std::uint32_t instruction) const;

  const CheckedFile &m_file;
  const fp::hw::NativeReport &m_report;
  SourceText m_source;
  Style m_style;
  bool m_all;
};

/// Returns the number of dependent samples in the chain: its length minus 1, or 0 without a chain.
[[nodiscard]] std::uint32_t dependentReads(const CheckedFile &file);

/// Returns a number's text: "27", "4.5".
[[nodiscard]] std::string decimal(double number);

} // namespace arbiter::tools
