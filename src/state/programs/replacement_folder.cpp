#include "state/programs/replacement_folder.h"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <sys/inotify.h>
#include <unistd.h>
#include <utility>

#include "fp_compiler/limits.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

constexpr std::int64_t kPollInterval = 10'000'000;    ///< ns between two reads of inotify
constexpr std::int64_t kScanInterval = 1'000'000'000; ///< ns between two scans of all files

std::int64_t coarseNow() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC_COARSE, &time);
  return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

} // namespace

ReplacementFolder *ReplacementFolder::instance() {
  static ReplacementFolder *const s_folder =
      settings().replacePath.empty() ? nullptr
                                     : new ReplacementFolder(expandPid(settings().replacePath));
  return s_folder;
}

ReplacementFolder::ReplacementFolder(std::string path) : m_path(std::move(path)) { watch(); }

ReplacementFolder::~ReplacementFolder() {
  if (m_notify >= 0)
    close(m_notify);
}

/// Starts to watch the folder, in this process. A descriptor inherited by fork would share its
/// events with the parent.
void ReplacementFolder::watch() {
  if (m_notify >= 0)
    close(m_notify);
  m_process = getpid();
  m_notify = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (m_notify < 0)
    return;
  // A writer that truncates the file first is noticed when it closes the file.
  constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE |
                                    IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
  if (inotify_add_watch(m_notify, m_path.c_str(), kEvents) < 0)
    close(std::exchange(m_notify, -1));
}

bool ReplacementFolder::read(const std::string &name, std::string &text) {
  const std::string path = pathOf(name);
  const std::lock_guard lock(m_mutex);
  // The state is read first, so that a write between the two calls is noticed later.
  m_files[name].state = stateOf(path.c_str());
  if (readFile(path.c_str(), fp::kMaxTextBytes, text))
    return !text.empty();
  if (errno == ENOENT)
    m_files[name].good.clear();
  else
    logError("state", "%s: %s", path.c_str(), std::strerror(errno));
  return false;
}

void ReplacementFolder::keepGood(const std::string &name, std::string text) {
  const std::lock_guard lock(m_mutex);
  m_files[name].good = std::move(text);
}

bool ReplacementFolder::lastGood(const std::string &name, std::string &text) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_files.find(name);
  if (it == m_files.end() || it->second.good.empty())
    return false;
  text = it->second.good;
  return true;
}

/// True if inotify has reported anything. The events do not matter, because the files are scanned.
bool ReplacementFolder::reported() {
  bool any = false;
  alignas(inotify_event) char events[4096];
  for (;;) {
    const ssize_t count = ::read(m_notify, events, sizeof events);
    if (count <= 0)
      return any;
    any = true;
    for (ssize_t at = 0; at < count;) {
      inotify_event event;
      std::memcpy(&event, events + at, sizeof event);
      if ((event.mask & (IN_IGNORED | IN_MOVE_SELF)) != 0) { // the folder has been replaced
        close(std::exchange(m_notify, -1));
        return true;
      }
      at += ssize_t(sizeof event + event.len);
    }
  }
}

void ReplacementFolder::scan() {
  const std::uint64_t next = m_generation.load(std::memory_order_relaxed) + 1;
  bool any = false;
  for (auto &[name, file] : m_files) {
    const FileState state = stateOf(pathOf(name).c_str());
    if (state == file.state || (state.exists && state.size == 0))
      continue;
    file.state = state;
    file.changed = next;
    any = true;
  }
  if (any)
    m_generation.store(next, std::memory_order_release);
}

void ReplacementFolder::poll() {
  const std::int64_t now = coarseNow();
  if (now < m_nextPoll.load(std::memory_order_relaxed))
    return;
  const std::unique_lock lock(m_mutex, std::try_to_lock);
  if (!lock) // another thread is polling
    return;
  m_nextPoll.store(now + kPollInterval, std::memory_order_relaxed);
  if (m_process != getpid())
    watch();
  const bool due = now >= m_nextScan;
  if (due && m_notify < 0)
    watch();
  if (!due && (m_notify < 0 || !reported()))
    return;
  m_nextScan = now + kScanInterval;
  scan();
}

bool ReplacementFolder::changedSince(const std::string &name, std::uint64_t generation) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_files.find(name);
  return it != m_files.end() && it->second.changed > generation;
}

} // namespace arbiter::state
