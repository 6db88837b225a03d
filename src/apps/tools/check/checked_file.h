#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/tools/advise/advise.h"
#include "apps/tools/language.h"
#include "apps/tools/profile_choice.h"
#include "fp_compiler/file_programs.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"

/// Holds the result of checking one program, for every form of output.
namespace arbiter::tools {

enum class FileStatus { Valid, OverNative, Invalid, Unreadable };

/// Returns "valid", "over_native", "invalid" or "unreadable", which are part of the JSON.
[[nodiscard]] const char *name(FileStatus status);

class CheckedFile {
public:
  std::string name; ///< as given; "-" is shown as "<stdin>"
  std::string text; ///< of the file; spans refer to it
  /// The part of the text that is the program; empty: all of it.
  std::optional<fp::Span> part;
  bool hasSiblings = false; ///< true if the file has other programs
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  FileStatus status = FileStatus::Valid;
  std::string fault; ///< for Unreadable: the reason
  fp::CheckResult result;
  const fp::hw::Profile *profile = nullptr; ///< the profile used; not owned
  fp::Limits limits;                        ///< of the language under the profile
  /// Set if requested: the suggestions, and the fixes that were made before.
  std::optional<std::vector<advise::Advice>> advice;
  std::optional<advise::Fixed> fixed;

  /// Returns the program's own text, which is passed to GL.
  [[nodiscard]] std::string_view source() const {
    return part ? std::string_view(text).substr(part->begin, part->end - part->begin) : text;
  }
  [[nodiscard]] fp::FileProgram program() const {
    return {language, part.value_or(fp::Span{0, std::uint32_t(text.size())})};
  }
  /// Returns the name. If the file has other programs, adds the language and line.
  [[nodiscard]] std::string title() const;
  /// Returns lackOf() of the card; empty for a file that cannot be read.
  [[nodiscard]] std::string_view lack() const {
    return status == FileStatus::Unreadable ? std::string_view() : lackOf(limits, language);
  }
  /// False if the card has no programs of the language: its limits and counts say nothing.
  [[nodiscard]] bool hasPrograms() const {
    return lack().empty() || tools::hasPrograms(limits, language);
  }
  /// True for diagnostics that make sense for the profile's card.
  [[nodiscard]] bool isShown(const fp::Diagnostic &diagnostic) const {
    return hasPrograms() || !isOfLimit(diagnostic);
  }
  /// True if the program has counts.
  [[nodiscard]] bool counted() const {
    return status == FileStatus::Valid || status == FileStatus::OverNative;
  }
  /// True for a program whose only errors are that it is over limits of the API.
  [[nodiscard]] bool isOverApiAlone() const;
  /// Returns the reasons for the native counts of a file that is counted(). They are computed at
  /// the first call, because that costs more than the check, and most files need none.
  [[nodiscard]] const fp::hw::NativeReport &native() const;
  [[nodiscard]] fp::hw::NativeReport &native() {
    return const_cast<fp::hw::NativeReport &>(std::as_const(*this).native());
  }

private:
  mutable std::optional<fp::hw::NativeReport> m_native;
};

/// Reads a file and checks its programs; "-" is standard input. For an unreadable file, returns one
/// element. Errors of the panel (the lines that begin with #@) belong to the first program.
/// \param language "auto", or a name of languageRows()
[[nodiscard]] std::vector<CheckedFile> checkFile(const std::string &path,
                                                 const std::string &language,
                                                 fp::LimitPolicy policy,
                                                 const fp::hw::Profile &profile);
/// Checks a file under the profile that its text selects.
[[nodiscard]] std::vector<CheckedFile> checkFile(const std::string &path,
                                                 const std::string &language,
                                                 fp::LimitPolicy policy, ProfileChoice &profiles);

/// Fills `advice` of the programs of one file.
/// \param fix makes every fix first: in `text`, which is then checked again, and in the file
void addAdvice(std::vector<CheckedFile> &programs, const std::string &path, bool fix,
               fp::LimitPolicy policy);

} // namespace arbiter::tools
