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
#include "util/thread.h"

namespace arbiter {

namespace detail {

constinit std::atomic<int> g_logLevel = -1;

int readLogLevel() noexcept {
  (void)settings(); // sets the level through configureLog
  const int level = g_logLevel.load(std::memory_order_relaxed);
  // A negative level here means that settings() is still running further up this thread's stack.
  return level < 0 ? int(LogLevel::Warn) : level;
}

} // namespace detail

namespace {

/// A descriptor and the identity of its file. An application may close descriptors it does not know
/// (daemons do) and open another file under the same number. No line of the log may go there.
struct Sink {
  int descriptor = -1;
  dev_t device = 0;
  ino_t inode = 0;

  static Sink of(int descriptor) {
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0)
      return {};
    return {descriptor, status.st_dev, status.st_ino};
  }
  /// True if the descriptor still refers to its file and there is room. The cap uses the file's
  /// size, as several processes may append to one file. Standard error may have been redirected
  /// since, but not to a socket: an application opened that after it had closed 2.
  [[nodiscard]] bool takes() const {
    struct stat status = {};
    if (descriptor < 0 || ::fstat(descriptor, &status) != 0)
      return false;
    const bool same = status.st_dev == device && status.st_ino == inode;
    if (descriptor == STDERR_FILENO)
      return same || !S_ISSOCK(status.st_mode);
    return same && std::uint64_t(status.st_size) < kMaxLogBytes;
  }
};

/// Standard error as it was when the library was loaded, and the log's file. A sink is never freed
/// or replaced, as another thread may be reading it.
constinit Sink g_standardError, g_file;
constinit std::atomic<const Sink *> g_sink = &g_standardError;

[[gnu::constructor]] void findStandardError() { g_standardError = Sink::of(STDERR_FILENO); }

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

void write(LogLevel level, const char *room, std::string_view text) noexcept {
  const int savedErrno = errno;
  const NoCancel scope;
  const Sink *const sink = g_sink.load(std::memory_order_acquire);
  if (sink->takes()) {
    try {
      std::string line =
          "arbiter[" + std::to_string(::getpid()) + "] " + levelName(level) + ": " + room + ": ";
      for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        line += (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F ? '?' : c;
      }
      if (line.back() != '\n')
        line += '\n';
      writeAll(sink->descriptor,
               line); // one write keeps lines of several threads and processes whole
    } catch (...) {
      // Out of memory: dropping the line is better than failing the application.
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
    // As in write(), the line is dropped.
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
  const bool toFile = path != nullptr && *path != '\0';
  const int descriptor = toFile ? openPrivate(path, OpenMode::Append) : -1;
  const bool opened = !toFile || descriptor >= 0;
  // A previous file stays open, as another thread may be writing to it. There is at most one.
  const Sink *sink = &g_standardError;
  if (descriptor >= 0) {
    g_file = Sink::of(descriptor);
    sink = &g_file;
  }
  g_sink.store(sink, std::memory_order_release);
  detail::g_logLevel.store(int(level), std::memory_order_relaxed);
  return opened;
}

} // namespace arbiter
