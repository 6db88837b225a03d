#pragma once
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

/// Adapts output to the terminal: block characters or ASCII, colors, and a progress line.
namespace arbiter::tools {

/// The style of a report's text.
struct Style {
  bool gauges = true;  ///< a bar for each count
  bool blocks = false; ///< true for Unicode block elements, false for ASCII
  bool color = false;  ///< ANSI colours
};

/// Returns the style for standard output. Colors require a terminal, NO_COLOR unset, and a TERM
/// other than "dumb".
/// \param gauges "auto": blocks on a terminal with a UTF-8 locale; "always": blocks with any UTF-8
/// locale; "never": numbers only
[[nodiscard]] Style styleOf(std::string_view gauges);
/// Returns the style for standard error, without gauges.
[[nodiscard]] Style styleOfErrors();

enum class Color : std::uint8_t { Good, Close, Bad, Dim, Error, Warning, Note, Place };
/// Returns the text in the color if the style has colors.
[[nodiscard]] std::string painted(std::string_view text, Color color, const Style &style);

/// Returns used / limit as a bar of ten cells. A number above 0 is always visible, and only a full
/// count fills the bar. A bar over the limit ends in '>'.
[[nodiscard]] std::string gauge(std::uint32_t used, std::uint32_t limit, const Style &style);

/// Replaces control bytes in a name or text from outside by \xNN, because a terminal would execute
/// them.
[[nodiscard]] std::string shown(std::string_view text);

/// Shows the progress of a long task in a line on standard error. Shows nothing if that is no
/// terminal, or until the task has run for a moment.
class Progress {
public:
  explicit Progress(std::size_t total);
  ~Progress() { clear(); }
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  void at(std::size_t done);
  /// Removes the line before other output.
  void clear();

private:
  using Clock = std::chrono::steady_clock;
  std::size_t m_total;
  Style m_style;
  bool m_terminal;
  bool m_drawn = false;
  Clock::time_point m_next;
};

} // namespace arbiter::tools
