#pragma once
#include <atomic>
#include <cstdint>
#include <string_view>

/// The log of a library that lives in other people's processes: lines of
/// "arbiter[pid] level: room: text" on standard error or in a file (ARBITER_LOG, see flags.def).
/// Nothing below warn is written unless asked for. Safe from any thread; never throws; errno is
/// kept. A control character in the text is written as '?', so that a program string cannot drive
/// a terminal.
namespace arbiter {

/// A warning is a mistake in Arbiter's own settings or something the host lacks; what an
/// application does wrong is Info at most.
enum class LogLevel : std::uint8_t { Off, Error, Warn, Info, Debug };

/// A log file stops growing here, whatever several processes write to it.
inline constexpr std::uint64_t kMaxLogBytes = 64u << 20;

namespace detail {
/// Negative until the environment has been read.
extern std::atomic<int> g_logLevel;
int readLogLevel() noexcept;
} // namespace detail

[[nodiscard]] inline bool logEnabled(LogLevel level) noexcept {
  int threshold = detail::g_logLevel.load(std::memory_order_relaxed);
  if (threshold < 0) [[unlikely]]
    threshold = detail::readLogLevel();
  return int(level) <= threshold;
}

/// \param room the part that speaks: "state", "layer", "compiler"
[[gnu::format(printf, 2, 3)]] void logError(const char *room, const char *format, ...) noexcept;
[[gnu::format(printf, 2, 3)]] void logWarn(const char *room, const char *format, ...) noexcept;
[[gnu::format(printf, 2, 3)]] void logInfo(const char *room, const char *format, ...) noexcept;
[[gnu::format(printf, 2, 3)]] void logDebug(const char *room, const char *format, ...) noexcept;

/// A text of any length and number of lines (a listing), written in one piece. The caller has
/// asked debugFlag(), so it is written unless the log is off; `level` is its label.
void logText(LogLevel level, const char *room, std::string_view title,
             std::string_view text) noexcept;

/// Sets level and file at once; the reader of the environment and tests call it. An empty path is
/// standard error. \returns false, with the log on standard error, if the file cannot be opened.
bool configureLog(LogLevel level, const char *path) noexcept;

} // namespace arbiter
