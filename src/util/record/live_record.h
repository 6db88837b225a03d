#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "util/record/record_text.h"

/// A report that survives any end of its process. While the process runs, the report's data lie in
/// a mapped file (TARGET.PID.running), which the kernel keeps if the process is killed. The report
/// is made by whoever comes first: the process itself when it exits, `arbiter run` when its command
/// is dead, or `arbiter stats` later.
///
/// The record holds texts and counters (record_text.h), not their meaning, so that another build
/// can read it. A text is a frame (before and after the rows) and rows.
namespace arbiter {

class LiveRecord {
public:
  static constexpr unsigned kCounters = 512;

  /// Creates a record in a mapped file, or in plain memory if a file cannot be mapped (no folder,
  /// no room, a file size limit). Returns null if there is no memory.
  /// \param target the path of the report
  /// \param named  the target contains the process number, so that no other report is there
  static LiveRecord *make(const std::string &target, bool named);
  /// Creates a record of which no report is made. Returns null if there is no memory.
  static LiveRecord *inMemory();

  /// Returns the record's kCounters counters. The report takes the numbers of its texts from there.
  [[nodiscard]] std::uint64_t *counters();
  /// Sets the text around the rows. Returns false if it is too long for the record; the previous
  /// text stays.
  bool setFrame(std::string_view before, std::string_view after);
  /// Appends a row. Returns false and adds nothing if there is no room.
  bool addRow(std::string_view row);

  /// Writes the report to its place atomically and removes the record's file. It allocates nothing
  /// and takes no lock, so that it is safe wherever the process ends.
  /// \returns false with errno set.
  bool finish();
  /// Writes the present report to `sink`; the record continues. Returns false if the sink fails.
  bool write(const TextSink &sink) const;

  /// Called in the child of a fork. The record becomes the child's own, in memory, and its report
  /// goes beside the parent's. It allocates nothing.
  void afterFork();

  /// Makes the report of a record whose process has ended or executes another program. It ignores a
  /// file that is no record, belongs to another user, or names another path than its own.
  static bool complete(const std::string &recordPath);
  /// Returns when the process began the record, in ns of the wall clock; 0 for other files.
  static std::int64_t beganAt(const std::string &recordPath);

private:
  struct Layout;
  static Layout *open(const std::string &path);
  bool report();
  Layout *m_layout = nullptr;
};

/// Makes the reports of records whose process has ended, oldest first. `pattern` is a target in
/// which %p stands for any number.
/// \returns how many were made.
int completeRecords(const std::string &pattern);
/// Returns the paths of the reports of a target, sorted. %p stands for any number, and numbers may
/// stand behind dots, as in the reports of forked children.
[[nodiscard]] std::vector<std::string> reportsOf(const std::string &pattern);

} // namespace arbiter
