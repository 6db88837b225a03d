#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fp_compiler/file_programs.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"
#include "tools/advise/advise.h"
#include "tools/language.h"
#include "tools/profile_choice.h"

/// One program that `arbiter check` looked at, as data for every way to show it.
namespace arbiter::tools {

enum class FileStatus { Valid, OverNative, Invalid, Unreadable };

/// "valid", "over-native", "invalid", "unreadable"; part of the JSON.
[[nodiscard]] const char *name(FileStatus status);

class CheckedFile {
public:
  std::string name; ///< as given; "-" is shown as "<stdin>"
  std::string text; ///< of the file; every span is a place in it
  /// The bytes of the text that are the program; none: all of it.
  std::optional<fp::Span> part;
  bool hasSiblings = false; ///< the file has other programs
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  FileStatus status = FileStatus::Valid;
  std::string fault; ///< Unreadable: why
  fp::CheckResult result;
  const fp::hw::Profile *profile = nullptr; ///< that it was judged by; of who had it checked
  fp::Limits limits;                        ///< of its language under the profile
  /// Where it was asked for: what there is to be said, and what was changed before that.
  std::optional<std::vector<advise::Advice>> advice;
  std::optional<advise::Fixed> fixed;

  /// The program's own text, which GL is given.
  [[nodiscard]] std::string_view source() const {
    return part ? std::string_view(text).substr(part->begin, part->end - part->begin) : text;
  }
  [[nodiscard]] fp::FileProgram program() const {
    return {language, part.value_or(fp::Span{0, std::uint32_t(text.size())})};
  }
  /// The name; of a program that has siblings with its language and its line.
  [[nodiscard]] std::string title() const;
  /// lackOf() the card; empty of a file that cannot be read.
  [[nodiscard]] std::string_view lack() const {
    return status == FileStatus::Unreadable ? std::string_view() : lackOf(limits, language);
  }
  /// False if the card has no programs of the language: its limits and counts say nothing.
  [[nodiscard]] bool hasPrograms() const {
    return lack().empty() || tools::hasPrograms(limits, language);
  }
  /// Those that the profile's card is the right judge of.
  [[nodiscard]] bool isShown(const fp::Diagnostic &diagnostic) const {
    return hasPrograms() || !isOfLimit(diagnostic);
  }
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

/// Reads a file and checks its programs; "-" is standard input. A file that cannot be read is one
/// element. An error of its panel (the lines that begin with #@) is one of its first program.
/// \param language "auto", or a name of languageRows()
[[nodiscard]] std::vector<CheckedFile> checkFile(const std::string &path,
                                                 const std::string &language,
                                                 fp::LimitPolicy policy,
                                                 const fp::hw::Profile &profile);
/// The same under the profile that is chosen by its text.
[[nodiscard]] std::vector<CheckedFile> checkFile(const std::string &path,
                                                 const std::string &language,
                                                 fp::LimitPolicy policy, ProfileChoice &profiles);

/// Fills `advice` of the programs of one file.
/// \param fix before that, every fix is made: in `text`, which is checked anew, and in the file
void addAdvice(std::vector<CheckedFile> &programs, const std::string &path, bool fix,
               fp::LimitPolicy policy);

} // namespace arbiter::tools
