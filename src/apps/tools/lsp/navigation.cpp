// Implements definition, references, highlights and rename with the front end's names.
#include "apps/tools/lsp/answers.h"
#include "fp_compiler/front/words/keywords.h"
#include "fp_compiler/limits.h"

namespace arbiter::tools::lsp {

namespace {

using fp::Access;
using fp::Name;
using fp::NameTable;
using fp::NameUse;

const NameTable &names(const View &view) { return view.analysis.inspection.names; }

const Name *nameAt(const View &view, std::uint32_t offset) {
  const NameUse *use = names(view).at(offset);
  return use ? &names(view).names()[use->name] : nullptr;
}

Json location(const View &view, fp::Span span) {
  return {{"uri", view.document.uri()}, {"range", view.range(span)}};
}

/// Calls `visit` for each use of the name at the offset.
template <typename Visit> void forUses(const View &view, std::uint32_t offset, Visit visit) {
  const NameUse *here = names(view).at(offset);
  if (!here)
    return;
  for (const NameUse &use : names(view).uses())
    if (use.name == here->name)
      visit(use);
}

bool isIdentifier(std::string_view word) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  return !word.empty() && word.size() <= fp::kMaxIdentifierBytes &&
         kLetters.find(word[0]) != std::string_view::npos &&
         word.find_first_not_of(std::string(kLetters) + "0123456789") == std::string_view::npos;
}

/// Returns why a word cannot name a variable in this text, or "".
std::string whyNot(const View &view, const std::string &word) {
  const std::string quoted = "'" + word.substr(0, 64) + "'";
  if (!isIdentifier(word))
    return quoted + " is no name: letters, digits, _ and $, and no digit first";
  const fp::ArbLanguage &language = fp::arbLanguage(view.analysis.language);
  if (fp::classify(word, language).keyword != fp::Keyword::None)
    return quoted + " is a reserved word of " + std::string(language.header);
  const Name *taken = names(view).find(word);
  if (!taken)
    return {};
  if (taken->declared.end == 0)
    return quoted + " is used in this program already, though it is not declared";
  return quoted + " is declared already, in line " +
         std::to_string(view.document.map().lineOf(taken->declared.begin) + 1);
}

/// Returns the name at the offset if it can be renamed.
Result<const Name *, Refusal> renamable(const View &view, std::uint32_t offset) {
  const Name *name = nameAt(view, offset);
  if (!name)
    return Refusal{"there is no name of a variable here"};
  if (view.analysis.language == fp::ir::Language::AtiFragment)
    return Refusal{"the registers and constants of !!ATIfs1.0 have fixed names"};
  if (isNvparse(view.analysis.language))
    return Refusal{"the registers and constants of !!RC1.0 and !!TS1.0 have fixed names"};
  if (name->declared.end == 0)
    return Refusal{"'" + std::string(name->text.substr(0, 64)) + "' is not declared"};
  return name;
}

} // namespace

Json definition(const View &view, std::uint32_t offset) {
  const Name *name = nameAt(view, offset);
  return name && name->declared.end != 0 ? location(view, name->declared) : Json();
}

Json references(const View &view, std::uint32_t offset, bool withDeclaration) {
  Json all = Json::array();
  forUses(view, offset, [&](const NameUse &use) {
    if (withDeclaration || use.access != Access::Declare)
      all.push_back(location(view, use.span));
  });
  return all;
}

Json highlights(const View &view, std::uint32_t offset) {
  constexpr int kRead = 2;
  constexpr int kWrite = 3;
  Json all = Json::array();
  forUses(view, offset, [&](const NameUse &use) {
    all.push_back(
        {{"range", view.range(use.span)}, {"kind", use.access == Access::Read ? kRead : kWrite}});
  });
  return all;
}

Result<Json, Refusal> prepareRename(const View &view, std::uint32_t offset) {
  const auto name = renamable(view, offset);
  if (!name)
    return name.error();
  return Json{{"range", view.range(names(view).at(offset)->span)},
              {"placeholder", std::string(name.value()->text)}};
}

Result<Json, Refusal> rename(const View &view, std::uint32_t offset, const std::string &newName) {
  const auto name = renamable(view, offset);
  if (!name)
    return name.error();
  Json edits = Json::array();
  if (newName != name.value()->text) {
    if (std::string why = whyNot(view, newName); !why.empty())
      return Refusal{std::move(why)};
    forUses(view, offset, [&](const NameUse &use) {
      edits.push_back({{"range", view.range(use.span)}, {"newText", newName}});
    });
  }
  Json changes = Json::object();
  changes[view.document.uri()] = std::move(edits);
  return Json{{"changes", std::move(changes)}};
}

} // namespace arbiter::tools::lsp
