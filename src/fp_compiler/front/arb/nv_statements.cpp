// Parses statements of NVIDIA's options: NV_fragment_program_option 3.11.2,
// NV_vertex_program2_option 2.14.2 and their successors. The other files of the parser have the
// parts of the ARB grammar.

#include <utility>

#include "fp_compiler/front/arb/parser.h"
#include "fp_compiler/front/nv/lowering.h"

namespace arbiter::fp {

/// True at <varSize> before TEMP or OUTPUT. Elsewhere the word is a free name.
bool Parser::atSize() const {
  return isNv() && !isVertex() && (atWord("SHORT") || atWord("LONG")) &&
         (atWord("TEMP", 1) || atWord("OUTPUT", 1));
}

bool Parser::parseSized() {
  m_size = text(m_tokens.next()) == "SHORT" ? RegisterSize::Short : RegisterSize::Long;
  const bool parsed =
      text(m_tokens.next()) == "TEMP" ? parseRegisters(SymbolKind::Temporary) : parseOutput();
  m_size = RegisterSize::Long;
  return parsed;
}

bool Parser::killsByTest() const {
  return isNv() && at(TokenKind::Identifier) && nv::ruleOf(text(m_tokens.peek())).has_value();
}

bool Parser::parseDestinationPart(nv::Statement &statement) {
  m_written = RegisterSize::Long;
  m_mayIndex = true;
  m_indexed.reset();
  if (!AssemblyParser::parseDestinationPart(statement))
    return false;
  m_mayIndex = false;
  statement.indexedResult = std::exchange(m_indexed, {});
  const ir::Destination &destination = statement.instruction.dst;
  if (isNv() && destination.file == ir::File::Output && !statement.indexedResult)
    checkSize(destination);
  return true;
}

/// Reports a result that is written under two sizes (NV_fragment_program_option 3.11.3.4).
void Parser::checkSize(const ir::Destination &destination) {
  const auto [entry, isNew] = m_resultSizes.try_emplace(destination.index, m_written);
  if (!isNew && entry->second != m_written)
    error(DiagnosticId::NvResultSize, destination.span,
          "this result is written as SHORT and as LONG", "declare it once, with one size");
}

/// Returns the option that has a word, if this program's option lacks it and the next one does not.
std::string Parser::laterOption(std::string_view word) const {
  const bool later =
      m_options.nv == ir::NvOption::First &&
      nv::classify(word, m_language, ir::NvOption::Second).keyword == Keyword::Opcode;
  if (!later)
    return {};
  return std::string("OPTION ") + (isVertex() ? "NV_vertex_program3" : "NV_fragment_program2") +
         " has it";
}

bool Parser::unknownNvStatement(const Token &first) {
  const std::string_view word = text(first);
  if (!isVertex() && (word == "SHORT" || word == "LONG"))
    error(DiagnosticId::UnknownInstruction, first.span,
          std::string(word) + " stands before TEMP or OUTPUT");
  else
    error(DiagnosticId::UnknownInstruction, first.span, "unknown instruction " + quote(word),
          unknownHint(first, laterOption(word)));
  settle(first);
  return false;
}

} // namespace arbiter::fp
