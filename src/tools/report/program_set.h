#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "tools/capture_index.h"
#include "tools/check/checked_file.h"

/// The programs that a report is about, checked and explained.
namespace arbiter::tools {

/// What a report says of a program. One that the card's driver would refuse for the API limits
/// alone does not fit either: its counts are shown all the same.
enum class Verdict : std::uint8_t { Fits, Over, Invalid, Unreadable };
inline constexpr std::size_t kVerdictCount = 4;

/// "fits", "does not fit", "invalid", "unreadable".
[[nodiscard]] const char *word(Verdict verdict);

struct ReportedProgram {
  CheckedFile file;     ///< its name as shown: below the folder; `native` is there if it has counts
  bool refused = false; ///< over API limits that the profile enforces; checked without them
  Verdict verdict = Verdict::Fits;
  int captured = -1; ///< index into ProgramSet::capture's programs, or -1
};

/// Its verdict, by `file` and `refused`.
[[nodiscard]] Verdict verdictOf(const ReportedProgram &program);

struct ProgramSet {
  std::string source; ///< what the command line named
  fp::hw::Profile profile;
  bool fromCapture = false;
  CaptureIndex capture; ///< empty but for a capture
  std::vector<ReportedProgram> programs;
  std::vector<std::string> faults; ///< "path: reason"

  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Checks a text that is not valid again without the API limits, to count what is wrong in nothing
/// else.
void admitRefused(ReportedProgram &program);

/// The folder holds records of `arbiter capture`.
[[nodiscard]] bool isCapture(const std::string &folder);

/// The programs of files and folders (findFiles()), in that order; of a capture, which is a single
/// folder, those with the most draws first. Shows its progress on standard error.
[[nodiscard]] ProgramSet readPrograms(const std::vector<std::string> &operands,
                                      const fp::hw::Profile &profile);

} // namespace arbiter::tools
