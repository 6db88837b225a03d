#include "util/record/live_record.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <new>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "util/file.h"

namespace arbiter {

namespace {
constexpr char kMagic[16] = "arbiter-record1";
constexpr std::size_t kFrameBytes = 96 << 10, kBytes = std::size_t(3) << 20;
constexpr std::size_t kPathBytes = 1024;
constexpr const char *kEnding = ".running";

/// A string of fixed capacity, as nothing may be allocated.
struct Path {
  char text[kPathBytes + 64] = {};
  std::size_t length = 0;
  Path &add(std::string_view part) {
    const std::size_t fits = std::min(part.size(), sizeof text - 1 - length);
    std::memcpy(text + length, part.data(), fits);
    length += fits;
    return *this;
  }
  Path &add(std::int64_t number) {
    char digits[24];
    char *at = digits + sizeof digits;
    do
      *--at = char('0' + number % 10);
    while ((number /= 10) != 0);
    return add(std::string_view(at, std::size_t(digits + sizeof digits - at)));
  }
};
} // namespace

/// The layout of the file, equal for 32-bit and 64-bit processes. Writes are ordered so that it is
/// consistent at every moment: texts first, then the fields that refer to them.
struct LiveRecord::Layout {
  char magic[sizeof kMagic];
  std::int32_t process;
  std::uint32_t named, forked, inFile;
  struct Moment {
    std::int64_t seconds, nanoseconds;
  } began;
  char target[kPathBytes];
  std::uint64_t counters[kCounters];
  struct Frame {
    std::uint32_t before, after;
    char text[kFrameBytes];
  } frames[2];
  std::atomic<std::uint32_t> frame; ///< the index of the current frame, 0 or 1
  std::atomic<std::uint32_t> rowsEnd;
  char rows[1]; ///< each its length in four bytes, then its text; up to kBytes

  static constexpr std::size_t kRowsAt =
      16 + 16 + sizeof(Moment) + kPathBytes + 8 * kCounters + 2 * (8 + kFrameBytes) + 8;
  static constexpr std::size_t kRowsBytes = kBytes - kRowsAt;

  void begin(const std::string &path, bool pathNamed, const timespec &now) {
    process = ::getpid();
    named = pathNamed;
    began = {now.tv_sec, now.tv_nsec};
    std::memcpy(target, path.data(), path.size());
    std::memcpy(magic, kMagic, sizeof magic);
  }
  /// True if no field of a file that another process left points outside of it.
  [[nodiscard]] bool isSound() const {
    const Frame &current = frames[frame.load() & 1];
    return std::memcmp(magic, kMagic, sizeof magic) == 0 && target[kPathBytes - 1] == '\0' &&
           std::size_t(current.before) + current.after <= kFrameBytes &&
           rowsEnd.load() <= kRowsBytes;
  }
  [[nodiscard]] Path recordPath() const {
    Path path;
    path.add(target).add(".").add(process).add(kEnding);
    return path;
  }
  /// Returns the report's path. A file that another program has written since this one began is not
  /// overwritten, and later numbers are tried in its place.
  [[nodiscard]] Path reportPath() const {
    constexpr int kMax = 100;
    for (int i = named == 0 && forked != 0 ? 1 : 0;; ++i) {
      Path path;
      path.add(target);
      if (i >= 1 && named == 0)
        path.add(".").add(process);
      if (i >= 1 + int(named == 0))
        path.add(".").add(i + int(named != 0));
      if (i == kMax || !isOthers(path.text))
        return path;
    }
  }
  [[nodiscard]] bool isOthers(const char *path) const {
    struct stat info = {};
    return ::lstat(path, &info) == 0 && S_ISREG(info.st_mode) &&
           (info.st_mtim.tv_sec > began.seconds ||
            (info.st_mtim.tv_sec == began.seconds && info.st_mtim.tv_nsec > began.nanoseconds));
  }
};

namespace {

/// Writes to a file with a buffer of its own.
struct FileSink {
  int descriptor;
  std::size_t used = 0;
  char buffer[4096];

  bool flush() {
    const bool good = writeAll(descriptor, {buffer, used});
    used = 0;
    return good;
  }
  static bool take(void *to, const char *bytes, std::size_t size) {
    auto &self = *static_cast<FileSink *>(to);
    while (size != 0) {
      if (self.used == sizeof self.buffer && !self.flush())
        return false;
      const std::size_t part = std::min(size, sizeof self.buffer - self.used);
      std::memcpy(self.buffer + self.used, bytes, part);
      self.used += part;
      bytes += part;
      size -= part;
    }
    return true;
  }
};

void *mapFile(const char *path, std::size_t bytes) {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur < bytes)
    return nullptr; // SIGXFSZ
  const int descriptor =
      ::open(path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY, 0600);
  if (descriptor < 0)
    return nullptr;
  // fallocate reserves the room: a mapped page that cannot be written back raises SIGBUS.
  void *mapping = MAP_FAILED;
  if (::fallocate(descriptor, 0, 0, off_t(bytes)) == 0)
    mapping = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  ::close(descriptor);
  if (mapping == MAP_FAILED)
    ::unlink(path);
  return mapping == MAP_FAILED ? nullptr : mapping;
}

} // namespace

LiveRecord *LiveRecord::make(const std::string &target, bool named) {
  static_assert(offsetof(Layout, rows) <= Layout::kRowsAt && sizeof(Layout) <= kBytes);
  static_assert(offsetof(Layout, counters) == 48 + kPathBytes &&
                    offsetof(Layout, frames) == 48 + kPathBytes + 8 * kCounters,
                "no holes that only some processors leave");
  if (target.size() >= kPathBytes)
    return nullptr;
  auto *const record = new (std::nothrow) LiveRecord;
  if (!record)
    return nullptr;
  timespec began = {};
  clock_gettime(CLOCK_REALTIME, &began);
  const std::string path = target + "." + std::to_string(::getpid()) + kEnding;
  void *memory = mapFile(path.c_str(), kBytes);
  if (!memory && errno == EEXIST) {
    // A record of this process number exists: exec() may have begun this program. Reports of all of
    // them are newer than the first one's beginning. kCoarse allows for the resolution of file
    // times.
    const std::int64_t earlier = beganAt(path);
    complete(path);
    constexpr std::int64_t kCoarse = 20'000'000, kSecond = 1'000'000'000;
    std::int64_t since = began.tv_sec * kSecond + began.tv_nsec - kCoarse;
    if (earlier != 0)
      since = std::min(since, earlier);
    began.tv_sec = time_t(since / kSecond);
    began.tv_nsec = long(since % kSecond);
    ::unlink(path.c_str());
    memory = mapFile(path.c_str(), kBytes);
  }
  const bool inFile = memory != nullptr;
  if (!memory)
    memory = ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    delete record;
    return nullptr;
  }
  record->m_layout = static_cast<Layout *>(memory);
  record->m_layout->inFile = inFile;
  record->m_layout->begin(target, named, began);
  return record;
}

LiveRecord *LiveRecord::inMemory() {
  auto *const record = new (std::nothrow) LiveRecord;
  void *const memory =
      ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (record && memory != MAP_FAILED) {
    record->m_layout = static_cast<Layout *>(memory);
    return record;
  }
  delete record;
  return nullptr;
}

std::uint64_t *LiveRecord::counters() { return m_layout->counters; }

bool LiveRecord::setFrame(std::string_view before, std::string_view after) {
  if (before.size() + after.size() > kFrameBytes)
    return false;
  const std::uint32_t next = (m_layout->frame.load(std::memory_order_relaxed) & 1) ^ 1;
  Layout::Frame &frame = m_layout->frames[next];
  frame.before = std::uint32_t(before.size());
  frame.after = std::uint32_t(after.size());
  std::memcpy(frame.text, before.data(), before.size());
  std::memcpy(frame.text + before.size(), after.data(), after.size());
  m_layout->frame.store(next, std::memory_order_release);
  return true;
}

bool LiveRecord::addRow(std::string_view row) {
  const std::uint32_t end = m_layout->rowsEnd.load(std::memory_order_relaxed);
  const auto size = std::uint32_t(row.size());
  if (row.size() + sizeof size > Layout::kRowsBytes - end)
    return false;
  char *const rows = m_layout->rows;
  std::memcpy(rows + end, &size, sizeof size);
  std::memcpy(rows + end + sizeof size, row.data(), row.size());
  m_layout->rowsEnd.store(end + std::uint32_t(sizeof size) + size, std::memory_order_release);
  return true;
}

bool LiveRecord::write(const TextSink &sink) const {
  const Layout &layout = *m_layout;
  const Layout::Frame &frame = layout.frames[layout.frame.load(std::memory_order_acquire) & 1];
  if (!fillIn(sink, {frame.text, frame.before}, layout.counters, kCounters))
    return false;
  const char *const rows = layout.rows;
  const std::uint32_t end = layout.rowsEnd.load(std::memory_order_acquire);
  std::uint32_t size = 0;
  for (std::uint32_t at = 0; end - at > sizeof size; at += size) {
    std::memcpy(&size, rows + at, sizeof size);
    if (!sink(at == 0 ? "\n    " : ",\n    "))
      return false;
    at += std::uint32_t(sizeof size);
    if (size > end - at || !sink({rows + at, size}))
      return false;
  }
  return (end == 0 || sink("\n  ")) &&
         fillIn(sink, {frame.text + frame.before, frame.after}, layout.counters, kCounters);
}

/// Writes the report to a temporary file and moves it into place.
bool LiveRecord::report() {
  const Path path = m_layout->reportPath();
  struct stat info = {};
  if (::lstat(path.text, &info) == 0 && !S_ISREG(info.st_mode)) {
    errno = ELOOP;
    return false;
  }
  Path aside = path;
  aside.add(".").add(::getpid()).add(".tmp");
  FileSink sink{openPrivate(aside.text, OpenMode::Truncate), 0, {}};
  if (sink.descriptor < 0)
    return false;
  bool good = write({&sink, FileSink::take}) && sink.flush();
  ::close(sink.descriptor);
  good = good && std::rename(aside.text, path.text) == 0;
  if (!good) {
    const int failure = errno;
    ::unlink(aside.text);
    errno = failure;
  }
  return good;
}

bool LiveRecord::finish() {
  const bool good = report();
  if (good) {
    const int before = errno;
    if (m_layout->inFile != 0)
      ::unlink(m_layout->recordPath().text);
    // The file belongs to this process now, and may be overwritten.
    m_layout->inFile = 0;
    timespec now = {};
    clock_gettime(CLOCK_REALTIME, &now);
    m_layout->began = {now.tv_sec, now.tv_nsec};
    errno = before;
  }
  return good;
}

/// Reads the record from the file into memory; null if there is none.
LiveRecord::Layout *LiveRecord::open(const std::string &path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0)
    return nullptr;
  struct stat info = {};
  void *memory = MAP_FAILED;
  if (::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == ::geteuid() &&
      info.st_size == off_t(kBytes))
    memory = ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE, descriptor, 0);
  ::close(descriptor);
  if (memory == MAP_FAILED)
    return nullptr;
  auto *const layout = static_cast<Layout *>(memory);
  if (layout->isSound() && path == layout->recordPath().text)
    return layout;
  ::munmap(memory, kBytes);
  return nullptr;
}

bool LiveRecord::complete(const std::string &recordPath) {
  LiveRecord record;
  record.m_layout = open(recordPath);
  if (!record.m_layout)
    return false;
  const bool good = record.report();
  if (good)
    ::unlink(recordPath.c_str());
  ::munmap(record.m_layout, kBytes);
  return good;
}

std::int64_t LiveRecord::beganAt(const std::string &recordPath) {
  Layout *const layout = open(recordPath);
  if (!layout)
    return 0;
  const std::int64_t began = layout->began.seconds * 1'000'000'000 + layout->began.nanoseconds;
  ::munmap(layout, kBytes);
  return began;
}

void LiveRecord::afterFork() {
  void *const own =
      ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (own == MAP_FAILED)
    return;
  const std::size_t used = Layout::kRowsAt + m_layout->rowsEnd.load(std::memory_order_acquire);
  std::memcpy(own, static_cast<const void *>(m_layout), std::min(used, kBytes));
  auto *const layout = static_cast<Layout *>(own);
  layout->inFile = 0;
  layout->forked = 1;
  layout->process = ::getpid();
  ::mremap(own, kBytes, kBytes, MREMAP_MAYMOVE | MREMAP_FIXED, m_layout);
}

} // namespace arbiter
