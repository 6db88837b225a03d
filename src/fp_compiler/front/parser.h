#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/front/binder.h"
#include "fp_compiler/front/keywords.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/symbols.h"

namespace arbiter::fp {

struct ParseResult {
  std::vector<Diagnostic> diagnostics; ///< in text order
  std::optional<ir::Program> program;  ///< empty if there is any error
  ResourceCounts counts;
};

/// Parses and checks an ARBfp1.0 program (3.11.2 to 3.11.6). Time and memory are linear in the
/// text; there is no recursion.
[[nodiscard]] ParseResult parseFragmentProgram(std::string_view text,
                                               const CompileOptions &options);

/// One statement a function. A function that returns bool returns false for a syntax error, which
/// it has reported; the statement is then given up and the parser goes on at the next one. Errors
/// of meaning are reported and the statement goes on.
class Parser {
public:
  Parser(std::string_view text, std::uint32_t begin, const CompileOptions &options,
         Reporter &reporter);

  void parse();
  [[nodiscard]] Binder &binder() { return m_binder; }

private:
  /// Whether a binding stands in a declaration or in an instruction, where a suffix may follow.
  enum class Place : std::uint8_t { Declaration, Operand };
  /// The rows of a parameter array, or the one row of a single parameter.
  using Rows = std::vector<std::uint16_t>;

  // parser.cpp: the program, its options, recovery, tokens
  void parseOptions();
  bool parseOption(bool late);
  void applyOption(const Token &name);
  void parseStatement();
  bool parseStatementBody(const Token &first, const Word &word);
  void parseEnd();
  bool unknownStatement(const Token &first);
  void recover();
  bool expect(TokenKind kind, const char *what, const char *hint = "");
  bool unexpected(const char *expected, std::string hint = {});
  bool unexpectedToken(const Token &token, const char *expected, std::string hint = {});
  [[nodiscard]] std::string describe(const Token &token) const;
  [[nodiscard]] std::string_view text(const Token &token) const { return m_tokens.text(token); }
  [[nodiscard]] Word keywordAt() const;
  [[nodiscard]] bool atWord(int ahead, std::string_view word) const;
  [[nodiscard]] Span spanFrom(std::uint32_t begin) const { return {begin, m_tokens.lastEnd()}; }
  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});

  // declarations.cpp
  bool parseTemp();
  bool parseAttrib();
  bool parseOutput();
  bool parseAlias();
  bool parseParam();
  bool parseParamArray(const Token &name);
  bool parseArraySize(std::optional<std::uint32_t> &size);
  bool parseArrayItem(std::optional<std::uint32_t> declaredSize, Rows &rows);
  bool newName(Token &name);
  void declare(const Token &name, SymbolKind kind, std::uint16_t index);

  // bindings.cpp
  bool parseAttributeBinding(Place place, std::uint16_t &row);
  bool parseResultBinding(Place place, std::uint16_t &row);
  bool parseProgramBinding(std::uint32_t begin, bool range, Rows &rows);
  bool parseConstant(bool isSigned, std::uint16_t &row);
  bool parseConstantVector(ir::Vec4 &value);
  bool parseNumber(bool isSigned, float &value);
  bool parseIndex(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &index);
  bool parseOptionalIndex(std::uint32_t limit, DiagnosticId id, const char *what,
                          std::uint32_t &index);
  bool parseBounded(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &value);
  bool unknownWord(const char *what, std::initializer_list<std::string_view> words,
                   std::initializer_list<std::string_view> vertexWords = {});

  // state_binding.cpp
  bool parseStateBinding(std::uint32_t begin, bool range, Rows &rows);
  bool parseMaterial(ir::StateRef &ref);
  bool parseLight(ir::StateRef &ref);
  bool parseLightModel(ir::StateRef &ref);
  bool parseLightProduct(ir::StateRef &ref);
  bool parseTexEnv(ir::StateRef &ref);
  bool parseFogOrDepth(ir::StateRef &ref, bool fog);
  bool parseMatrix(std::uint32_t begin, bool range, Rows &rows);
  bool parseMatrixName(ir::StateRef &ref);
  bool parseMatrixRows(bool range, std::uint32_t &first, std::uint32_t &last);
  bool parseFace(ir::StateRef &ref);

  // instructions.cpp
  bool parseInstruction(const Token &opcode, const Word &word);
  bool parseDestination(ir::Destination &destination);
  bool parseDestinationRegister(ir::Destination &destination);
  bool readOnlyDestination(const Token &first, const Word &word);
  bool parseMask(std::uint8_t &mask);
  bool parseExtendedSwizzle(ir::Operand &operand);
  bool parseTexture(ir::Instruction &instruction);
  bool parseTarget(Token &word);

  // operands.cpp
  bool parseSource(bool scalar, ir::Operand &operand);
  bool parseSwzSource(ir::Operand &operand);
  bool parseSourceRegister(ir::Operand &operand);
  bool parseNamedSource(ir::Operand &operand);
  bool parseArrayElement(const Token &name, const Symbol &array, ir::Operand &operand);
  bool parseSwizzle(bool scalar, ir::Swizzle &swizzle);
  bool undeclared(const Token &name);
  bool skipIndex();

  std::string_view m_text;
  const Limits &m_limits;
  LimitPolicy m_policy;
  Reporter &m_reporter;
  TokenStream m_tokens;
  Binder m_binder;
  SymbolTable m_symbols;
  ir::Options m_options;
  std::vector<Rows> m_arrays;
  /// Ranges make many elements of little text, so their number has a limit of its own.
  static constexpr std::size_t kMaxArrayEntries = 65536;
  std::size_t m_arrayEntries = 0;
  struct UnitUse {
    bool used = false;
    ir::TexTarget target = ir::TexTarget::Tex2D;
  };
  std::vector<UnitUse> m_units;
};

} // namespace arbiter::fp
