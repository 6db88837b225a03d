#include "util/log.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "util/file.h"
#include "util/flags.h"

namespace arbiter {

namespace detail {

constinit std::atomic<int> g_logLevel = -1;

int readLogLevel() noexcept {
  (void)settings(); // sets the level through configureLog
  const int level = g_logLevel.load(std::memory_order_relaxed);
  // Still negative: settings() is being built further up this very thread's stack.
  return level < 0 ? int(LogLevel::Warn) : level;
}

} // namespace detail

namespace {

constinit std::atomic<int> g_descriptor = STDERR_FILENO;

const char *levelName(LogLevel level) {
  switch (level) {
  case LogLevel::Off:
    return "off";
  case LogLevel::Error:
    return "error";
  case LogLevel::Warn:
    return "warn";
  case LogLevel::Info:
    return "info";
  case LogLevel::Debug:
    return "debug";
  }
  return "?";
}

/// A cap by the file's size, not by our own count: several processes may append to one file.
bool roomLeft(int descriptor) {
  if (descriptor == STDERR_FILENO)
    return true;
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && std::uint64_t(status.st_size) < kMaxLogBytes;
}

void write(LogLevel level, const char *room, std::string_view text) noexcept {
  const int savedErrno = errno;
  const int descriptor = g_descriptor.load(std::memory_order_relaxed);
  if (roomLeft(descriptor)) {
    try {
      std::string line =
          "arbiter[" + std::to_string(::getpid()) + "] " + levelName(level) + ": " + room + ": ";
      for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        line += (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F ? '?' : c;
      }
      if (line.back() != '\n')
        line += '\n';
      writeAll(descriptor, line); // one write: lines of several threads and processes stay whole
    } catch (...) {
      // Out of memory while logging: the application matters more than the line.
    }
  }
  errno = savedErrno;
}

void writeVa(LogLevel level, const char *room, const char *format, va_list args) noexcept {
  char text[2048];
  const int length = std::vsnprintf(text, sizeof text, format, args);
  if (length < 0)
    return;
  if (std::size_t(length) >= sizeof text)
    std::memcpy(text + sizeof text - 4, "...", 4);
  write(level, room, text);
}

void writeFormatted(LogLevel level, const char *room, const char *format, va_list args) noexcept {
  if (logEnabled(level))
    writeVa(level, room, format, args);
}

} // namespace

void logError(const char *room, const char *format, ...) noexcept {
  va_list args;
  va_start(args, format);
  writeFormatted(LogLevel::Error, room, format, args);
  va_end(args);
}

void logWarn(const char *room, const char *format, ...) noexcept {
  va_list args;
  va_start(args, format);
  writeFormatted(LogLevel::Warn, room, format, args);
  va_end(args);
}

void logInfo(const char *room, const char *format, ...) noexcept {
  va_list args;
  va_start(args, format);
  writeFormatted(LogLevel::Info, room, format, args);
  va_end(args);
}

void logDebug(const char *room, const char *format, ...) noexcept {
  va_list args;
  va_start(args, format);
  writeFormatted(LogLevel::Debug, room, format, args);
  va_end(args);
}

void logText(LogLevel level, const char *room, std::string_view title,
             std::string_view text) noexcept {
  if (!logEnabled(LogLevel::Error))
    return;
  try {
    std::string all(title);
    all += '\n';
    all += text;
    write(level, room, all);
  } catch (...) {
    // As in write().
  }
}

void logFlag(DebugFlag flag, const char *room, const char *format, ...) noexcept {
  if (!debugFlag(flag) || !logEnabled(LogLevel::Error))
    return;
  va_list args;
  va_start(args, format);
  writeVa(LogLevel::Debug, room, format, args);
  va_end(args);
}

bool configureLog(LogLevel level, const char *path) noexcept {
  int descriptor = STDERR_FILENO;
  if (path != nullptr && *path != '\0')
    descriptor = openPrivate(path, OpenMode::Append);
  const bool opened = descriptor >= 0;
  // An earlier file stays open: another thread may be writing to it, and there is at most one.
  g_descriptor.store(opened ? descriptor : STDERR_FILENO, std::memory_order_relaxed);
  detail::g_logLevel.store(int(level), std::memory_order_relaxed);
  return opened;
}

} // namespace arbiter
