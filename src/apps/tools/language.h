#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/file_programs.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/resources.h"

/// Maps the language names of the command line to program languages.
namespace arbiter::tools {

struct LanguageRow {
  const char *name; ///< "arbvp", for --language
  const char *header;
  fp::ir::Language language;
};
/// The number of languages; every fp::ir::Language is below it.
inline constexpr std::size_t kLanguageCount = 5;
[[nodiscard]] std::span<const LanguageRow> languageRows();
[[nodiscard]] const LanguageRow &languageRow(fp::ir::Language language);

/// Returns "auto" and the names of languageRows().
[[nodiscard]] std::vector<std::string> languageNames();

/// Returns the language with that name. For "auto" the text's header decides. Without a known
/// header it is ARBfp1.0, so that the compiler reports the header.
[[nodiscard]] fp::ir::Language chooseLanguage(std::string_view name, std::string_view text);

/// Returns a file's programs of the named language; "auto" means all of them. If the file has none
/// of that language, returns the whole file as one program of it.
[[nodiscard]] std::vector<fp::FileProgram> choosePrograms(std::string_view name,
                                                          std::string_view file);

/// Returns the program to use if a file stands for one program: the first fragment program, or the
/// first program if there is none.
[[nodiscard]] fp::FileProgram chooseProgram(std::string_view name, std::string_view file);

/// Returns the language's title, such as "ARBvp1.0"; for NVIDIA's languages the header's, such as
/// "VP2.0".
[[nodiscard]] std::string languageTitle(fp::ir::Language language, std::string_view text);

/// Returns the file's name. If the file has several programs, adds the program's language and line:
/// "bump.vfp, ARBfp1.0 of line 15".
[[nodiscard]] std::string titleOf(const std::string &name, std::string_view file,
                                  const fp::FileProgram &program);

/// Returns the limits of the language's target. ATI's language has its own limits. nvparse's
/// languages have the limits of the card's combiners and texture shaders.
[[nodiscard]] fp::Limits limitsOf(const fp::hw::Profile &profile, fp::ir::Language language);

/// False if the card has no programs of the language, so that its limits say nothing.
[[nodiscard]] bool hasPrograms(const fp::Limits &limits, fp::ir::Language language);
/// Says why a card runs no program of the language: "the card has no fragment programs". Empty if
/// it runs them.
[[nodiscard]] std::string_view lackOf(const fp::Limits &limits, fp::ir::Language language);
/// True for a diagnostic of an API limit. A card without such programs has no such limit.
[[nodiscard]] bool isOfLimit(const fp::Diagnostic &diagnostic);
/// Returns the resource of such a diagnostic: "limit_alu_instructions" is "alu_instructions". Null
/// if the limit is of no resource that is listed.
[[nodiscard]] const fp::ResourceRow *limitedRow(const fp::Diagnostic &diagnostic);

} // namespace arbiter::tools
