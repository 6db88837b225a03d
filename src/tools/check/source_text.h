#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"

namespace arbiter::tools {

/// A program's text by lines, for reports that point at many places of it: locate() of
/// fp_compiler/diagnostic.h in logarithmic time. The text must outlive it.
class SourceText {
public:
  explicit SourceText(std::string_view text);

  /// As fp::locate(): from 1, a column counts bytes; CR LF, LF and CR each end a line.
  [[nodiscard]] fp::LineColumn at(std::uint32_t offset) const;

  /// The span on one line: white space and comments become one blank, bytes outside printable
  /// ASCII a question mark, what is longer than `most` bytes ends in "...".
  [[nodiscard]] std::string statement(fp::Span span, std::size_t most) const;

private:
  std::string_view m_text;
  std::vector<std::uint32_t> m_lines; ///< where each begins
};

} // namespace arbiter::tools
