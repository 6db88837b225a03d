#pragma once
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <sys/types.h>
#include <unordered_map>

#include "util/file.h"

namespace arbiter::state {

/// The folder of ARBITER_REPLACE: texts by file name (HASH.fp), and which of them have changed. It
/// uses inotify, and checks each file's state once a second for folders and links that inotify does
/// not report. Any thread may call.
class ReplacementFolder {
public:
  /// Returns the folder, or null if ARBITER_REPLACE names none. Never destroyed.
  [[nodiscard]] static ReplacementFolder *instance();
  explicit ReplacementFolder(std::string path);
  ~ReplacementFolder();
  ReplacementFolder(const ReplacementFolder &) = delete;
  ReplacementFolder &operator=(const ReplacementFolder &) = delete;

  /// Reads a file, and watches it from now on, even if it does not exist.
  /// \returns false if there is none; an empty file counts as none, because editors create it first
  bool read(const std::string &name, std::string &text);
  [[nodiscard]] std::string pathOf(const std::string &name) const { return m_path + "/" + name; }

  /// Keeps the text of a valid file, to be used while an edit is wrong. It is dropped with the
  /// file.
  void keepGood(const std::string &name, std::string text);
  /// Gets the kept text. \returns false if there is none
  bool lastGood(const std::string &name, std::string &text);

  /// Looks for changes, if the last look was a while ago. It is cheap enough for each frame.
  void poll();
  /// Returns a number that grows when poll() has seen a change.
  [[nodiscard]] std::uint64_t generation() const {
    return m_generation.load(std::memory_order_acquire);
  }
  /// True if poll() saw the file change after `generation`.
  [[nodiscard]] bool changedSince(const std::string &name, std::uint64_t generation);

private:
  struct File {
    FileState state;
    std::uint64_t changed = 0; ///< the generation of the last change
    std::string good;
  };

  void watch();
  [[nodiscard]] bool reported();
  void scan();

  const std::string m_path;
  std::mutex m_mutex;
  std::unordered_map<std::string, File> m_files;
  std::atomic<std::uint64_t> m_generation{0};
  std::atomic<std::int64_t> m_nextPoll{0}; ///< in monotonic ns
  std::int64_t m_nextScan = 0;
  int m_notify = -1;
  pid_t m_process = 0; ///< the process that m_notify belongs to
};

} // namespace arbiter::state
