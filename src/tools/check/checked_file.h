#pragma once
#include <optional>
#include <string>
#include <utility>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"
#include "tools/advise/advise.h"
#include "tools/profile_choice.h"

/// One file that `arbiter check` looked at, as data for every way to show it.
namespace arbiter::tools {

enum class FileStatus { Valid, OverNative, Invalid, Unreadable };

/// "valid", "over-native", "invalid", "unreadable"; part of the JSON.
[[nodiscard]] const char *name(FileStatus status);

class CheckedFile {
public:
  std::string name; ///< as given; "-" is shown as "<stdin>"
  std::string text;
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  FileStatus status = FileStatus::Valid;
  std::string fault; ///< Unreadable: why
  fp::CheckResult result;
  const fp::hw::Profile *profile = nullptr; ///< that it was judged by; of who had it checked
  fp::Limits limits;                        ///< of its language under the profile
  /// Where it was asked for: what there is to be said, and what was changed before that.
  std::optional<std::vector<advise::Advice>> advice;
  std::optional<advise::Fixed> fixed;

  /// There is a program, and it has counts.
  [[nodiscard]] bool counted() const {
    return status == FileStatus::Valid || status == FileStatus::OverNative;
  }
  /// Why the native counts of a file that is counted() are what they are. Made when it is first
  /// asked for, as it costs more than the check itself: nothing is shown of most files.
  [[nodiscard]] const fp::hw::NativeReport &native() const;
  [[nodiscard]] fp::hw::NativeReport &native() {
    return const_cast<fp::hw::NativeReport &>(std::as_const(*this).native());
  }

private:
  mutable std::optional<fp::hw::NativeReport> m_native;
};

/// Reads and checks one file; "-" is standard input. An error of its panel (the lines that begin
/// with #@) is one of the file.
/// \param language "auto", or a name of languageRows()
[[nodiscard]] CheckedFile checkFile(const std::string &path, const std::string &language,
                                    fp::LimitPolicy policy, const fp::hw::Profile &profile);
/// The same under the profile that is chosen by its text.
[[nodiscard]] CheckedFile checkFile(const std::string &path, const std::string &language,
                                    fp::LimitPolicy policy, ProfileChoice &profiles);

/// Fills `advice`.
/// \param fix before that, every fix is made: in `text`, which is checked anew, and in the file
void addAdvice(CheckedFile &file, const std::string &path, bool fix, fp::LimitPolicy policy);

} // namespace arbiter::tools
