#pragma once
#include <optional>
#include <string>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"

/// One file that `arbiter check` looked at, as data for every way to show it.
namespace arbiter::tools {

enum class FileStatus { Valid, OverNative, Invalid, Unreadable };

/// "valid", "over-native", "invalid", "unreadable"; part of the JSON.
[[nodiscard]] const char *name(FileStatus status);

struct CheckedFile {
  std::string name; ///< as given; "-" is shown as "<stdin>"
  std::string text;
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  FileStatus status = FileStatus::Valid;
  std::string fault; ///< Unreadable: why
  fp::CheckResult result;
  fp::Limits limits; ///< of its language under the profile
  /// Why the native counts are what they are; by explain().
  std::optional<fp::hw::NativeReport> native;

  /// There is a program, and it has counts.
  [[nodiscard]] bool counted() const {
    return status == FileStatus::Valid || status == FileStatus::OverNative;
  }
};

/// Reads and checks one file; "-" is standard input.
/// \param language "auto", or a name of languageRows()
[[nodiscard]] CheckedFile checkFile(const std::string &path, const std::string &language,
                                    fp::LimitPolicy policy, const fp::hw::Profile &profile);

/// Fills `native` of a file that has counts. Slower than the check itself: for what is shown.
void explain(CheckedFile &file);

} // namespace arbiter::tools
