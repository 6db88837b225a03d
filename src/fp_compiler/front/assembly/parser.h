#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/front/c_like/statements.h"
#include "fp_compiler/front/core/reader.h"
#include "fp_compiler/front/nv/labels.h"
#include "fp_compiler/front/words/keywords.h"
#include "fp_compiler/front/words/other_words.h"
#include "fp_compiler/front/words/parts.h"
#include "fp_compiler/front/words/targets.h"
#include "fp_compiler/native_interface.h"

namespace arbiter::fp {

struct ParseResult {
  std::vector<Diagnostic> diagnostics; ///< in text order
  std::optional<ir::Program> program;  ///< empty if there is any error
  ResourceCounts counts;
  NativeInterface native; ///< of NVIDIA's own languages (native/parser.h)
};

/// The grammar that the ARB languages, NVIDIA's options and NVIDIA's own languages share: a
/// program's frame, instructions and their parts, suffixes, numbers, conditions, labels.
class AssemblyParser : protected Reader {
public:
  /// Parses the program, and sets all of the result but its diagnostics and its interface.
  void run(ParseResult &result);

protected:
  /// The words in which the languages' messages differ.
  struct Style {
    c_like::Dialect dialect;
    bool colors;      ///< r, g, b and a name components
    const char *unit; ///< a texture image unit in a hint
    /// The expected component of an address register, and the hints.
    const char *addressDot, *addressComponent, *addressHint, *addressAdvice;
  };
  AssemblyParser(const SourceText &source, const CompileOptions &options, const Limits &limits,
                 ir::Language language, const Style &style);

  // parser.cpp: the program, its statements
  void parse();
  bool parseOption(bool late);
  [[nodiscard]] Vocabulary vocabulary() const;
  [[nodiscard]] std::string statementHintInC(const Token &first) const;
  /// Returns the hint for a word that begins no statement.
  /// \param later the option that has it; empty if none has
  [[nodiscard]] std::string unknownHint(const Token &first, const std::string &later) const;
  [[nodiscard]] std::string operandHint(const Token &word) const;
  bool parseInstruction(const Token &opcode, const Word &word);
  bool parseFlow(const Token &opcode, const Word &word);
  bool parseLabel(const Token &name);
  /// Counts the statement. Keeps it if the program can still load.
  void keep(const nv::Statement &statement, Span opcode);
  [[nodiscard]] Word keywordAt() const;
  [[nodiscard]] bool endsStatement(const Token &token) const override;

  // parts.cpp: the parts of instructions
  bool expectPart(ir::Opcode op, Part part);
  [[nodiscard]] std::optional<Span> missingPart(bool first);
  [[nodiscard]] PartTexts parts() const { return partsBehind(m_text, m_behindOpcode); }
  [[nodiscard]] std::string surplusHint(ir::Opcode op) const;
  bool parseDestination(ir::Destination &destination);
  bool parseAddressDestination(ir::Destination &destination);
  bool parseOperands(nv::Statement &statement);
  bool parseSource(bool scalar, ir::Operand &operand, bool &absolute);
  bool parseAddressSource(ir::Operand &operand);
  bool parseAddressComponent(std::uint8_t &component);
  bool parseMask(std::uint8_t &mask);
  bool parseSwizzle(bool scalar, ir::Swizzle &swizzle, std::uint32_t begin = 0);
  bool parseTest(nv::Test &test);
  bool parseConditionMask(nv::Test &test);
  bool parseTarget(const char *expected, bool shadows, Token &word, const TargetRow *&row);

  // numbers.cpp
  /// An integer behind a sign.
  struct Offset {
    Token token;
    bool negative = false;
    std::uint32_t magnitude = 0;
    [[nodiscard]] std::int16_t value() const {
      return std::int16_t(negative ? -std::int32_t(magnitude) : std::int32_t(magnitude));
    }
  };
  bool parseOffset(std::optional<Offset> &offset);
  bool parseIndex(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &index);
  bool expectInteger(Token &token, std::uint32_t &value, const char *what = "an integer");
  bool parseNumber(float &value);
  bool parseVector(ir::Vec4 &value);

  /// An operand before its suffix.
  struct Base {
    ir::Operand &operand;
    bool scalar;
    bool absolute;         ///< within bars
    bool &negative;        ///< the sign before the operand or its bars
    bool inner;            ///< the sign right before it
    bool hasSuffix = true; ///< a suffix may follow
  };

  // The differences between the languages.
  /// Returns the reserved word that an identifier is.
  [[nodiscard]] virtual Word wordOf(std::string_view identifier) const = 0;
  /// Returns the opcode that an identifier of the language begins with.
  [[nodiscard]] virtual std::optional<ir::Opcode> baseOf(std::string_view identifier) const = 0;
  /// Returns the words that may begin a statement, without those of offers(), and what saturates.
  [[nodiscard]] virtual Vocabulary statementWords() const = 0;
  [[nodiscard]] virtual bool offers(ir::Opcode op) const = 0;
  [[nodiscard]] virtual bool hasConditions() const = 0; ///< and bars
  [[nodiscard]] virtual bool hasSecondCondition() const { return false; }
  [[nodiscard]] virtual bool hasAddressVectors() const = 0;
  [[nodiscard]] virtual bool hasPlusSigns() const { return true; } ///< before operands
  /// True where an instruction that kills has a test in place of its operand.
  [[nodiscard]] virtual bool killsByTest() const = 0;
  [[nodiscard]] virtual bool atLabel() const { return at(TokenKind::Identifier); }
  /// True for a word that is the next statement's, where a part of this one is missing.
  [[nodiscard]] virtual bool endsParts(const Token &word) const { return endsStatement(word); }
  [[nodiscard]] virtual std::string suffixHint(std::string_view suffix, bool scalar) const;
  virtual void applyOption(const Token &name) = 0;
  virtual void parseStatement() = 0;
  virtual bool parseDestinationPart(nv::Statement &statement);
  virtual bool parseDestinationRegister(ir::Destination &destination) = 0;
  virtual bool parseOperand(nv::Statement &statement, int number);
  virtual bool parseBase(Base &base) = 0;
  virtual bool parseFlowParts(nv::Statement &statement, const Token &opcode);
  /// Parses <extendedSwizzle>, from the comma before it.
  virtual bool parseExtendedSwizzle(ir::Instruction &) { return true; }
  /// Parses a texture image unit and its target, from the comma before them.
  virtual bool parseTexture(ir::Instruction &instruction) = 0;
  /// Consumes the name of an address register. Returns its first row in the IR.
  virtual std::optional<std::uint16_t> takeAddress(Access access) = 0;
  /// Parses an integer from 0 to limit - 1.
  virtual bool parseBounded(std::uint32_t limit, DiagnosticId id, const char *what,
                            std::uint32_t &value) = 0;
  /// Parses a component of a constant: a number with its sign.
  virtual bool parseScalar(float &value);
  /// Checks what the whole text has to have, and makes the program.
  virtual void finish(Span end) = 0;

  const Limits &m_limits;
  const Style m_style;
  Binder m_binder;
  ir::Options m_options;
  nv::Labels m_labels{m_text, m_reporter};
  std::vector<nv::Statement> m_statements; ///< of NVIDIA's options and languages
  std::uint32_t m_behindOpcode = 0; ///< the end of the opcode of the instruction that is read
};

} // namespace arbiter::fp
