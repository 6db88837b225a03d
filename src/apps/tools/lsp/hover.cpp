#include <algorithm>

#include "apps/scene/panel/complete.h"
#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/native_text.h"
#include "apps/tools/lsp/reading.h"
#include "apps/tools/lsp/reference_text.h"
#include "fp_compiler/front/ati/words.h"

namespace arbiter::tools::lsp {

namespace {

using fp::reference::Entry;

/// The text to show, and the span that it describes.
struct Found {
  std::string markdown;
  fp::Span span;
};

const char *kindText(fp::SymbolKind kind, bool ati) {
  switch (kind) {
  case fp::SymbolKind::Temporary:
    return "temporary";
  case fp::SymbolKind::Attribute:
    return "attribute";
  case fp::SymbolKind::Parameter:
    return ati ? "constant" : "parameter";
  case fp::SymbolKind::ParameterArray:
    return "array of parameters";
  case fp::SymbolKind::Output:
    return "result";
  case fp::SymbolKind::Address:
    return "address register";
  case fp::SymbolKind::Unknown:
    break;
  }
  return ati ? "register" : "not declared";
}

class Hover {
public:
  explicit Hover(const View &view)
      : m_view(view), m_reading(view.document, view.analysis),
        m_ati(view.analysis.language == fp::ir::Language::AtiFragment),
        m_nvparse(isNvparse(view.analysis.language)) {}

  std::optional<Found> at(std::uint32_t offset) const {
    if (const fp::NameUse *use = m_view.analysis.inspection.names.at(offset))
      return ofName(*use);
    const auto token = m_reading.at(offset);
    if (!token)
      return std::nullopt;
    if (m_nvparse)
      return ofNvparseWord(*token);
    if (auto found = ofBinding(*token))
      return found;
    return m_ati ? ofAtiWord(*token) : ofWord(*token);
  }

private:
  std::string lines(const fp::Name &name, fp::Access access) const {
    std::string text;
    std::uint32_t count = 0;
    for (const fp::NameUse &use : m_view.analysis.inspection.names.uses()) {
      if (m_view.analysis.inspection.names.names()[use.name].text != name.text ||
          use.access != access)
        continue;
      constexpr std::uint32_t kListed = 8;
      if (++count <= kListed)
        text += (count == 1 ? " " : ", ") +
                std::to_string(m_view.document.map().lineOf(use.span.begin) + 1);
      else if (count == kListed + 1)
        text += ", ...";
    }
    return count == 0 ? "never" : "in line" + text;
  }

  Found ofName(const fp::NameUse &use) const {
    const fp::Name &name = m_view.analysis.inspection.names.names()[use.name];
    std::string text;
    if (name.declared.end != 0)
      if (const auto token = m_reading.at(name.declared.begin)) {
        const fp::Span statement = m_reading.statement(*token);
        text = codeBlock(m_view.document.text(statement).substr(0, 400));
        text += declaredAs(statement);
      }
    text = "**" + std::string(kindText(name.kind, m_ati || m_nvparse)) + "** `" +
           std::string(name.text.substr(0, 100)) + "`\n\n" + text;
    if (m_nvparse)
      text += registerText(name.text) + "\n";
    text += "\nread " + lines(name, fp::Access::Read);
    if (name.kind != fp::SymbolKind::Attribute && name.kind != fp::SymbolKind::Parameter &&
        name.kind != fp::SymbolKind::ParameterArray)
      text += "; written " + lines(name, fp::Access::Write);
    return {std::move(text), use.span};
  }

  /// Describes a register of nvparse's languages.
  static std::string registerText(std::string_view word) {
    for (const fp::reference::AtiSource &row : fp::reference::nvparseRegisters())
      if (row.count == 0 ? row.word == word
                         : word.size() == row.word.size() + 1 && word.starts_with(row.word))
        return std::string(row.doc) + "\n";
    return {};
  }

  /// Describes the bindings in a declaration.
  std::string declaredAs(fp::Span statement) const {
    std::string text;
    for (std::size_t i = m_reading.before(statement.begin);
         i < m_reading.size() && m_reading.span(i).end <= statement.end && text.size() < 800; ++i)
      if (const auto chain = m_reading.chain(i); chain.size() > 1 && chain[0] == i)
        if (const auto *binding = longest(chain).first)
          text += "`" + binding->path() + "`: " + std::string(binding->doc) + "\n";
    return text.empty() ? text : text + "\n";
  }

  /// Returns the longest binding at the start of a chain of words, and its number of words.
  std::pair<const fp::reference::Binding *, std::size_t>
  longest(const std::vector<std::size_t> &chain) const {
    const std::vector<std::string_view> words = m_reading.words(chain);
    for (std::size_t length = words.size(); length > 1; --length)
      if (const auto *binding =
              fp::reference::findBinding(m_view.analysis.language, std::span(words).first(length)))
        return {binding, length};
    return {nullptr, 0};
  }

  std::optional<Found> ofBinding(std::size_t token) const {
    const std::vector<std::size_t> chain = m_reading.chain(token);
    const auto [binding, length] = longest(chain);
    if (!binding)
      return std::nullopt;
    return Found{codeBlock(binding->path()) + documentationOf(*binding),
                 {m_reading.span(chain[0]).begin, m_reading.span(chain[length - 1]).end}};
  }

  /// Returns the cost of the instruction at the offset.
  std::string costHere(std::uint32_t offset) const {
    const auto &program = m_view.analysis.inspection.check.program;
    const fp::hw::NativeReport &native = m_view.analysis.native;
    if (!program)
      return {};
    for (std::size_t i = 0; i < std::min(program->code.size(), native.costs.size()); ++i) {
      const fp::Span span = program->code[i].span;
      if (offset < span.begin || offset >= span.end)
        continue;
      const fp::hw::InstructionCost &cost = native.costs[i];
      std::string text = "\n\nhere: " + (cost.gone ? std::string("gone, nothing of it is left")
                                                   : costText(cost.slots, cost.textures));
      if (native.nodes.size() > 1 && !cost.gone)
        text += ", node " + std::to_string(cost.node + 1);
      for (const fp::hw::Reason &reason : native.reasons)
        if (std::find(reason.instructions.begin(), reason.instructions.end(), i) !=
            reason.instructions.end())
          text += "  \n" + reason.text;
      return text;
    }
    return {};
  }

  Found ofOpcode(std::size_t token, fp::ir::Opcode op) const {
    std::string text = codeBlock(signatureOf(op, m_view.analysis.language)) + documentationOf(op);
    if (const std::string cost = costOfOpcode(op, m_view.profile); !cost.empty())
      text += "\n\n" + cost;
    text += costHere(m_reading.span(token).begin);
    return {std::move(text), m_reading.span(token)};
  }

  std::optional<Found> ofEntry(std::span<const Entry> entries, std::size_t token) const {
    for (const Entry &entry : entries)
      if (entry.word == m_reading.text(token))
        return Found{codeBlock(entry.word) + documentationOf(entry), m_reading.span(token)};
    return std::nullopt;
  }

  std::optional<Found> ofWord(std::size_t token) const {
    const fp::Word word = m_reading.word(token);
    if (word.keyword == fp::Keyword::Opcode)
      return ofOpcode(token, word.op);
    if (auto found = ofEntry(fp::reference::keywords(m_view.analysis.language), token))
      return found;
    if (token > 0 && m_reading.word(token - 1).keyword == fp::Keyword::Option)
      return ofEntry(fp::reference::options(m_view.analysis.language), token);
    return ofEntry(fp::reference::targets(), token);
  }

  std::optional<Found> ofAtiWord(std::size_t token) const {
    const std::string_view word = m_reading.text(token);
    const fp::Span span = m_reading.span(token);
    if (token > 0 && m_reading.kind(token - 1) == fp::TokenKind::Dot) {
      // A suffix such as "2x" has different meanings after a destination and after an argument.
      const bool destination = m_reading.comma(m_reading.statementBegin(token), token) == token;
      for (const auto &entries :
           {fp::reference::atiCoordinates(), destination ? fp::reference::atiDestinationModifiers()
                                                         : fp::reference::atiArgumentModifiers()})
        if (auto found = ofEntry(entries, token))
          return found;
      return std::nullopt;
    }
    for (const fp::reference::AtiOp &op : fp::reference::atiOps())
      if (op.word == word)
        return Found{codeBlock(signatureOf(op)) + documentationOf(op), span};
    for (const fp::reference::AtiSource &source : fp::reference::atiSources())
      if (source.count == 0 ? source.word == word
                            : fp::ati::numbered(word, source.word[0]).value_or(99) < source.count)
        return Found{codeBlock(word) + std::string(source.doc), span};
    return ofEntry(fp::reference::atiStatements(), token);
  }

  std::optional<Found> ofNvparseWord(std::size_t token) const {
    using fp::ir::Language;
    for (const Language language : {m_view.analysis.language, Language::Combiners})
      if (auto found = ofEntry(fp::reference::nvparseWords(language), token))
        return found;
    return std::nullopt;
  }

  const View &m_view;
  Reading m_reading;
  bool m_ati;
  bool m_nvparse;
};

} // namespace

Json hover(const View &view, std::uint32_t offset) {
  if (const auto place = scene::explainPanel(view.document.text(), offset)) {
    const scene::Candidate &word = place->candidates.front();
    const std::string markdown = codeBlock(word.word) + "\n" + std::string(word.meaning) +
                                 " (docs/reference/panel_words.md)";
    return {{"contents", {{"kind", "markdown"}, {"value", markdown}}},
            {"range", view.range(place->replaced)}};
  }
  const auto found = Hover(view).at(offset);
  if (!found)
    return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", found->markdown}}},
          {"range", view.range(found->span)}};
}

} // namespace arbiter::tools::lsp
