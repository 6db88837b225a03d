#include "apps/tools/check/terminal.h"

#include <algorithm>
#include <cstdlib>
#include <langinfo.h>
#include <locale.h>
#include <unistd.h>

namespace arbiter::tools {

namespace {

constexpr std::uint64_t kCells = 10;
constexpr auto kFirst = std::chrono::milliseconds(200);
constexpr auto kBetween = std::chrono::milliseconds(50);

/// True if the user's locale has UTF-8. Does not change the process's locale.
bool localeIsUtf8() {
  const locale_t locale = ::newlocale(LC_CTYPE_MASK, "", locale_t{});
  if (locale == locale_t{})
    return false;
  const bool utf8 = std::string_view(::nl_langinfo_l(CODESET, locale)) == "UTF-8";
  ::freelocale(locale);
  return utf8;
}

bool colorsWanted() {
  const char *none = std::getenv("NO_COLOR");
  const char *terminal = std::getenv("TERM");
  return (none == nullptr || *none == '\0') && terminal != nullptr && *terminal != '\0' &&
         std::string_view(terminal) != "dumb";
}

std::string repeated(std::string_view cell, std::uint64_t count) {
  std::string text;
  while (count-- > 0)
    text += cell;
  return text;
}

std::string blocks(std::uint32_t used, std::uint32_t limit) {
  constexpr std::string_view kEighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  if (used > limit)
    return repeated("█", kCells - 1) + ">";
  const std::uint64_t most = kCells * 8;
  const std::uint64_t exact = limit == 0 ? 0 : std::uint64_t(used) * most / limit;
  const std::uint64_t eighths = used == 0 ? 0 : std::max<std::uint64_t>(exact, 1);
  const std::uint64_t part = eighths % 8;
  return repeated("█", eighths / 8) + std::string(kEighths[part]) +
         repeated("·", kCells - eighths / 8 - (part != 0 ? 1 : 0));
}

std::string ascii(std::uint32_t used, std::uint32_t limit) {
  if (used > limit)
    return "[" + repeated("#", kCells - 1) + ">]";
  const std::uint64_t exact = limit == 0 ? 0 : used * kCells / limit;
  const std::uint64_t cells = used == 0 ? 0 : std::max<std::uint64_t>(exact, 1);
  return "[" + repeated("#", cells) + repeated(".", kCells - cells) + "]";
}

} // namespace

Style styleOf(std::string_view gauges) {
  const bool terminal = ::isatty(STDOUT_FILENO) != 0;
  Style style;
  style.gauges = gauges != "never";
  style.blocks = (terminal || gauges == "always") && localeIsUtf8();
  style.color = terminal && colorsWanted();
  return style;
}

Style styleOfErrors() {
  Style style;
  style.color = ::isatty(STDERR_FILENO) != 0 && colorsWanted();
  return style;
}

std::string painted(std::string_view text, Color color, const Style &style) {
  constexpr std::string_view kCodes[] = {"\x1b[32m",   "\x1b[33m",   "\x1b[31m",   "\x1b[2m",
                                         "\x1b[1;31m", "\x1b[1;35m", "\x1b[1;36m", "\x1b[1m"};
  if (!style.color)
    return std::string(text);
  return std::string(kCodes[std::size_t(color)]) + std::string(text) + "\x1b[0m";
}

std::string gauge(std::uint32_t used, std::uint32_t limit, const Style &style) {
  const std::string bar = style.blocks ? blocks(used, limit) : ascii(used, limit);
  const bool close = std::uint64_t(used) * 10 > std::uint64_t(limit) * 9;
  return painted(bar, used > limit ? Color::Bad : close ? Color::Close : Color::Good, style);
}

std::string shown(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) {
      safe += c;
      continue;
    }
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", byte);
    safe += code;
  }
  return safe;
}

Progress::Progress(std::size_t total)
    : m_total(total), m_terminal(::isatty(STDERR_FILENO) != 0), m_next(Clock::now() + kFirst) {
  m_style.blocks = m_terminal && localeIsUtf8();
}

void Progress::at(std::size_t done) {
  if (!m_terminal || Clock::now() < m_next)
    return;
  m_next = Clock::now() + kBetween;
  m_drawn = true;
  const auto parts = std::uint32_t(done * 1000 / std::max<std::size_t>(m_total, 1));
  std::fprintf(stderr, "\r%s %zu of %zu files", gauge(parts, 1000, m_style).c_str(), done, m_total);
}

void Progress::clear() {
  if (m_drawn)
    std::fputs("\r\x1b[K", stderr);
  m_drawn = false;
}

} // namespace arbiter::tools
