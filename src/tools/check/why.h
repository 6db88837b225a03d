#pragma once
#include <string>

#include "fp_compiler/resources.h"
#include "tools/check/checked_file.h"
#include "tools/check/source_text.h"
#include "tools/check/terminal.h"

namespace arbiter::tools {

/// Why a program takes what it takes: a NativeReport as text, each part pointing into the source.
/// A part that the report lacks is an empty text. Requires a file that is counted(); it must
/// outlive this.
class Why {
public:
  /// \param all every reason with every instruction, not the largest few
  Why(const CheckedFile &file, const Style &style, bool all);

  /// The parts of one resource's count, the largest first.
  [[nodiscard]] std::string reasons(const fp::ResourceRow &row) const;
  /// One line: whose counts these are, nodes, dependent reads, cycles.
  [[nodiscard]] std::string headline() const;
  /// The longest chain of dependent reads, an instruction a line.
  [[nodiscard]] std::string chain() const;
  /// The texture nodes, each with its samples and why it begins.
  [[nodiscard]] std::string nodes() const;
  /// The estimate by unit, and what it leaves out.
  [[nodiscard]] std::string cycles() const;
  /// Each instruction with what it takes.
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

/// Samples of the chain that depend on another: its length less one; 0 without a chain.
[[nodiscard]] std::uint32_t dependentReads(const CheckedFile &file);

/// "27", "4.5".
[[nodiscard]] std::string decimal(double number);

} // namespace arbiter::tools
