#pragma once
#include <initializer_list>

#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/reading.h"
#include "apps/tools/lsp/reference_text.h"

namespace arbiter::tools::lsp {

/// Values of the protocol's CompletionItemKind.
enum ItemKind {
  kFunction = 3,
  kVariable = 6,
  kModule = 9,
  kProperty = 10,
  kValue = 12,
  kKeyword = 14,
  kEnumMember = 20,
  kConstant = 21,
};

/// A set of kinds of variables that are possible at a position.
using Kinds = std::initializer_list<fp::SymbolKind>;

/// Completes a word from the tokens before it, because a text that is being written is incomplete.
class Completion {
public:
  Completion(const View &view, std::uint32_t offset)
      : m_view(view), m_reading(view.document, view.analysis), m_language(view.analysis.language),
        m_offset(offset), m_replaced{offset, offset} {
    m_next = m_reading.before(offset);
    const auto at = m_reading.at(offset);
    // The word that is being written is replaced as a whole, and does not count as a token before
    // the position.
    if (at && m_reading.span(*at).begin < offset && isWord(m_reading.kind(*at))) {
      m_replaced = m_reading.span(*at);
      m_next = *at;
    }
  }

  Json run();

private:
  static bool isWord(fp::TokenKind kind) {
    return kind == fp::TokenKind::Identifier || kind == fp::TokenKind::Dimension ||
           kind == fp::TokenKind::Integer;
  }

  // completion.cpp: items of all languages
  void add(std::string_view word, ItemKind kind, const std::string &detail,
           const std::string &documentation = {});
  void add(std::span<const fp::reference::Entry> entries, ItemKind kind);
  void addHeaders();
  void addPanelWords();

  void behindDot();
  void addSegment(std::vector<std::string_view> path, const fp::reference::Segment &segment);

  /// The operand and instruction at the cursor.
  struct Operand {
    bool known = false;
    fp::ir::Opcode op = fp::ir::Opcode::Mov;
    int number = -1; ///< -1: the destination
    /// True if the operand is a scalar.
    [[nodiscard]] bool scalar() const {
      return number >= 0 && number < info(op).operandCount() && info(op).shapes[number] == 'S';
    }
  };

  Operand operand() const;
  bool insideBrackets() const;
  void addComponents(const Operand &here);

  // completion_arb.cpp: statements of the ARB languages
  void inStatement();
  void addStatements();
  void addNvOpcodes();
  void addOptions();
  void addKeywords(std::initializer_list<fp::Keyword> keywords);
  void addNames(Kinds kinds);
  void afterEquals(std::initializer_list<fp::Keyword> keywords, Kinds kinds);
  void inInstruction();

  // NVIDIA's own languages
  void addOwnHeaders();
  void inOwnStatement();
  void addOwnStatements();
  void inOwnInstruction();

  // completion_ati.cpp
  void inAtiStatement();
  void addAtiSources(std::string_view word);
  void addAtiSuffixes(bool nested);

  // nvparse's languages
  void inNvparseStatement();
  void addNvparseRegisters();

  const View &m_view;
  Reading m_reading;
  fp::ir::Language m_language;
  std::uint32_t m_offset;
  fp::Span m_replaced;    ///< the range that an item's text replaces
  std::size_t m_next = 0; ///< number of tokens before the replaced range
  Json m_items = Json::array();
};

} // namespace arbiter::tools::lsp
