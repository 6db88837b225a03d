#pragma once
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

/// What the terminal can show: blocks or ASCII, colours, a line that is written over.
namespace arbiter::tools {

/// How the text of a report is drawn.
struct Style {
  bool gauges = true;  ///< a bar for each count
  bool blocks = false; ///< bars and lines of Unicode's block elements; else ASCII
  bool colour = false; ///< ANSI colours
};

/// The style for standard output.
/// \param gauges "auto": blocks on a terminal whose character set is UTF-8; "always": blocks
///        wherever the locale's is; "never": numbers alone
/// Colours are for terminals only, and not where NO_COLOR is set or TERM is "dumb".
[[nodiscard]] Style styleOf(std::string_view gauges);
/// Likewise for standard error, where there are no gauges.
[[nodiscard]] Style styleOfErrors();

enum class Colour : std::uint8_t { Good, Close, Bad, Dim, Error, Warning, Note, Place };
/// The text in that colour, or as it is.
[[nodiscard]] std::string painted(std::string_view text, Colour colour, const Style &style);

/// used / limit as a bar of ten cells: anything above 0 shows, only a full count fills it, and what
/// is over the limit ends in '>'.
[[nodiscard]] std::string gauge(std::uint32_t used, std::uint32_t limit, const Style &style);

/// A name or a text of the outside world: control bytes, which a terminal would obey, as \xNN.
[[nodiscard]] std::string shown(std::string_view text);

/// A line on standard error that says how far a long task is; nothing where that is no terminal,
/// or before the task has run for a moment.
class Progress {
public:
  explicit Progress(std::size_t total);
  ~Progress() { clear(); }
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  void at(std::size_t done);
  /// Takes the line away, before something else is written.
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
