#pragma once
#include <atomic>
#include <cstdint>
#include <string_view>

/// The log of a library that lives in other people's processes. It writes lines of "arbiter[pid]
/// level: room: text" to standard error or to a file (ARBITER_LOG, see flags.def). The default
/// level is warn. It is safe from any thread, never throws, and keeps errno. Control characters are
/// written as '?', so that a program string cannot control a terminal.
namespace arbiter {

/// A warning reports a mistake in Arbiter's own settings or a missing feature of the host. An
/// application's mistake is Info at most.
enum class LogLevel : std::uint8_t { Off, Error, Warn, Info, Debug };

/// The log file stops growing at this size, however many processes write to it.
inline constexpr std::uint64_t kMaxLogBytes = 64u << 20;

namespace detail {
/// The level is negative until the environment has been read.
extern std::atomic<int> g_logLevel;
int readLogLevel() noexcept;
} // namespace detail

[[nodiscard]] inline bool logEnabled(LogLevel level) noexcept {
  int threshold = detail::g_logLevel.load(std::memory_order_relaxed);
  if (threshold < 0) [[unlikely]]
    threshold = detail::readLogLevel();
  return int(level) <= threshold;
}

/// Logs one line.
/// \param room the part that speaks: "state", "layer", "compiler"
[[gnu::format(printf, 2, 3)]] void logError(const char *room, const char *format, ...) noexcept;
[[gnu::format(printf, 2, 3)]] void logWarn(const char *room, const char *format, ...) noexcept;
[[gnu::format(printf, 2, 3)]] void logInfo(const char *room, const char *format, ...) noexcept;
[[gnu::format(printf, 2, 3)]] void logDebug(const char *room, const char *format, ...) noexcept;

/// Logs a text of any length (a listing) in one piece. It is written unless the log is off, as the
/// caller has checked debugFlag(); `level` is only its label.
void logText(LogLevel level, const char *room, std::string_view title,
             std::string_view text) noexcept;

/// Sets level and file at once, for the reader of the environment and for tests. An empty path is
/// standard error.
/// \returns false if the file cannot be opened; the log then goes to standard error.
bool configureLog(LogLevel level, const char *path) noexcept;

} // namespace arbiter
