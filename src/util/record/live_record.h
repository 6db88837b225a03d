#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "util/record/record_text.h"

/// A report of a process that is there whatever ends it: while the process runs, what the report
/// will say lies in a file that is mapped (TARGET.PID.running), so that the kernel keeps it when
/// the process is killed. The first to come makes the report of it: the process itself when it
/// exits, `arbiter run` when its command is dead, or `arbiter stats` later.
///
/// The record holds texts and counters (record_text.h), and nothing of their meaning, so that a
/// reader of another build serves as well. A text is a frame (before and after rows) and rows.
namespace arbiter {

class LiveRecord {
public:
  static constexpr unsigned kCounters = 512;

  /// A record in a mapped file, or in plain memory where there can be none (no folder, no room, a
  /// limit of files' sizes). Null without memory.
  /// \param target where the report goes
  /// \param named  the target has the process's number in its name: no other report is there
  static LiveRecord *make(const std::string &target, bool named);
  /// One that nothing is to become of. Null without memory.
  static LiveRecord *inMemory();

  /// kCounters of them, in the record: numbers of the texts are read from there when the report is
  /// made.
  [[nodiscard]] std::uint64_t *counters();
  /// Sets the text around the rows. False if it is too long for the record: the one before stays.
  bool setFrame(std::string_view before, std::string_view after);
  /// Adds a row behind those that are there. False where there is no more room: nothing is added.
  bool addRow(std::string_view row);

  /// The report as of now, written to its place in one step; the record's file goes. No allocation
  /// and no lock: safe wherever the process ends. \returns false with errno set.
  bool finish();
  /// Writes the report as of now to `sink`; the record goes on. False if the sink fails.
  bool write(const TextSink &sink) const;

  /// In the child of a fork: the record becomes the child's own, in memory, and its report goes
  /// beside the parent's. No allocation.
  void afterFork();

  /// Of a file whose process is gone, or goes on as another program. Does nothing to a file that is
  /// no record, is not the user's, or names another place than its own.
  static bool complete(const std::string &recordPath);
  /// When its process began it, ns of the wall clock; 0 of a file that is no record.
  static std::int64_t beganAt(const std::string &recordPath);

private:
  struct Layout;
  static Layout *open(const std::string &path);
  bool report();
  Layout *m_layout = nullptr;
};

/// Makes the reports of records whose process is gone: those of `pattern`, a target in which %p is
/// any number. The one that began first is first. \returns how many were made.
int completeRecords(const std::string &pattern);

} // namespace arbiter
