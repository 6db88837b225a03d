#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "apps/tools/capture_index.h"
#include "apps/tools/check/checked_file.h"

/// Collects and checks the programs of a report.
namespace arbiter::tools {

/// The report's verdict on a program. A program that only the API limits exclude does not fit
/// either, but its counts are shown.
enum class Verdict : std::uint8_t { Fits, Over, Invalid, Unreadable };
inline constexpr std::size_t kVerdictCount = 4;

/// Returns "fits", "does not fit", "invalid" or "unreadable".
[[nodiscard]] const char *word(Verdict verdict);

struct ReportedProgram {
  CheckedFile file;     ///< its name is relative to the folder; `native` is set if it has counts
  bool refused = false; ///< true if over API limits that the profile enforces; then checked without
                        ///< them
  Verdict verdict = Verdict::Fits;
  int captured = -1; ///< index into ProgramSet::capture's programs, or -1
};

/// Returns a program's verdict from `file` and `refused`.
[[nodiscard]] Verdict verdictOf(const ReportedProgram &program);

struct ProgramSet {
  std::string source; ///< the operands of the command line
  fp::hw::Profile profile;
  bool fromCapture = false;
  CaptureIndex capture; ///< set only for a capture
  std::vector<ReportedProgram> programs;
  std::vector<std::string> faults; ///< as "path: reason"

  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Checks an invalid text again without the API limits, to get counts if only those make it
/// invalid.
void admitRefused(ReportedProgram &program);

/// True if the folder holds records of `arbiter capture`.
[[nodiscard]] bool isCapture(const std::string &folder);

/// Reads the programs of files and folders in the order of findFiles(). For a single capture
/// folder, programs with the most draws come first. Shows progress on standard error.
[[nodiscard]] ProgramSet readPrograms(const std::vector<std::string> &operands,
                                      const fp::hw::Profile &profile);

} // namespace arbiter::tools
