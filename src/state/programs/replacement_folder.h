#pragma once
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <sys/types.h>
#include <unordered_map>

#include "util/file.h"

namespace arbiter::state {

/// The folder of ARBITER_REPLACE: texts by file name (HASH.fp), and which of them changed. Changes
/// are seen by inotify, and by a look at each file's state once a second, which also serves folders
/// and links that inotify does not report. Any thread may call.
class ReplacementFolder {
public:
  /// Null unless ARBITER_REPLACE names a folder. Never destroyed.
  [[nodiscard]] static ReplacementFolder *instance();
  explicit ReplacementFolder(std::string path);
  ~ReplacementFolder();
  ReplacementFolder(const ReplacementFolder &) = delete;
  ReplacementFolder &operator=(const ReplacementFolder &) = delete;

  /// Reads a file and watches it from now on, whether it is there or not.
  /// \returns false where there is none. An empty file counts as none: editors write it first.
  bool read(const std::string &name, std::string &text);
  [[nodiscard]] std::string pathOf(const std::string &name) const { return m_path + "/" + name; }

  /// The text of a file that proved valid: what stands in for it while an edit is wrong. Gone with
  /// the file.
  void keepGood(const std::string &name, std::string text);
  /// \returns false where there is none.
  bool lastGood(const std::string &name, std::string &text);

  /// Looks for changes, if the last look is a while ago. Fit to be called for each frame.
  void poll();
  /// Grows when poll() has seen a change.
  [[nodiscard]] std::uint64_t generation() const {
    return m_generation.load(std::memory_order_acquire);
  }
  /// Whether poll() saw the file change after `generation`.
  [[nodiscard]] bool changedSince(const std::string &name, std::uint64_t generation);

private:
  struct File {
    FileState state;
    std::uint64_t changed = 0; ///< the generation
    std::string good;
  };

  void watch();
  [[nodiscard]] bool reported();
  void scan();

  const std::string m_path;
  std::mutex m_mutex;
  std::unordered_map<std::string, File> m_files;
  std::atomic<std::uint64_t> m_generation{0};
  std::atomic<std::int64_t> m_nextPoll{0}; ///< monotonic ns
  std::int64_t m_nextScan = 0;
  int m_notify = -1;
  pid_t m_process = 0; ///< that m_notify belongs to
};

} // namespace arbiter::state
