#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/file_programs.h"
#include "fp_compiler/hw/profile.h"

/// The languages of programs, as the command line names them.
namespace arbiter::tools {

struct LanguageRow {
  const char *name; ///< "arbvp", for --language
  const char *header;
  fp::ir::Language language;
};
/// How many there are; an fp::ir::Language is below it.
inline constexpr std::size_t kLanguageCount = 5;
[[nodiscard]] std::span<const LanguageRow> languageRows();
[[nodiscard]] const LanguageRow &languageRow(fp::ir::Language language);

/// "auto" and the names of languageRows().
[[nodiscard]] std::vector<std::string> languageNames();

/// The language of that name; for "auto" the one that the text's header names, or ARBfp1.0 where it
/// names none, so that the header is what is reported.
[[nodiscard]] fp::ir::Language chooseLanguage(std::string_view name, std::string_view text);

/// The programs of a file that are meant: for "auto" all of them, else those of the language; where
/// there is none of it, the whole file as a text of that language.
[[nodiscard]] std::vector<fp::FileProgram> choosePrograms(std::string_view name,
                                                          std::string_view file);

/// The one that is meant where a file stands for one program: of several the first fragment
/// program, without one the first.
[[nodiscard]] fp::FileProgram chooseProgram(std::string_view name, std::string_view file);

/// "ARBvp1.0", or the "VP2.0" of a text that is in one of NVIDIA's own languages.
[[nodiscard]] std::string languageTitle(fp::ir::Language language, std::string_view text);

/// The file's name; where the file has several programs, with the program's language and line:
/// "bump.vfp, ARBfp1.0 of line 15".
[[nodiscard]] std::string titleOf(const std::string &name, std::string_view file,
                                  const fp::FileProgram &program);

/// The limits of the language's target; for ATI's those of the language itself, for nvparse's those
/// of the card's combiners and texture shaders.
[[nodiscard]] fp::Limits limitsOf(const fp::hw::Profile &profile, fp::ir::Language language);

/// False if the card has no programs of the language, so that its limits say nothing.
[[nodiscard]] bool hasPrograms(const fp::Limits &limits, fp::ir::Language language);
/// What a card lacks that runs no program of the language itself: "the card has no fragment
/// programs". Empty of any other.
[[nodiscard]] std::string_view lackOf(const fp::Limits &limits, fp::ir::Language language);
/// A diagnostic of a limit of the API, which is none of a card's that has no such programs.
[[nodiscard]] bool isOfLimit(const fp::Diagnostic &diagnostic);

} // namespace arbiter::tools
