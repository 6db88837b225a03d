#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/diagnostic.h"

namespace arbiter::tools {

/// Finds lines and columns in a text in logarithmic time, unlike locate() of
/// fp_compiler/diagnostic.h. It serves reports with many positions. The text must outlive the
/// object.
class SourceText {
public:
  explicit SourceText(std::string_view text);

  /// Returns the line and column, from 1; a column counts bytes. CR LF, LF and CR each end a line,
  /// as for fp::locate().
  [[nodiscard]] fp::LineColumn at(std::uint32_t offset) const;

  /// Returns the span on one line. White space and comments become one blank, bytes outside
  /// printable ASCII a question mark. A text longer than `most` bytes ends in "...".
  [[nodiscard]] std::string statement(fp::Span span, std::size_t most) const;

private:
  std::string_view m_text;
  std::vector<std::uint32_t> m_lines; ///< start of each line
};

} // namespace arbiter::tools
