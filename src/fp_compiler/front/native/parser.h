#pragma once
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/front/c_like/statements.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/native/language.h"
#include "fp_compiler/front/nv/labels.h"
#include "fp_compiler/front/nv/lowering.h"
#include "fp_compiler/front/parser.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/words/names.h"

namespace arbiter::fp::native {

/// Parses and checks a program in one of NVIDIA's own languages, from its header on
/// (NV_fragment_program 3.11.3, NV_vertex_program 2.14.1.7 and 2.14.4, NV_vertex_program2
/// 2.14.1.8). It is lowered to the IR in the same way as programs under NVIDIA's options
/// (nv/lowering.h). Time and memory are linear in the text, except for inlined subroutines. There
/// is no recursion.
/// \param names if not null, gets every name of the text
[[nodiscard]] ParseResult parse(ir::NativeLanguage language, std::string_view text,
                                const CompileOptions &options, NameTable *names = nullptr);

/// Local parameters are numbered in 16 bits, and those with names come last.
inline constexpr std::uint32_t kMaxLocals = 65536 - kMaxNamedParameters;

/// The parser, with one function for each statement. A function that returns bool returns false
/// after it has reported a syntax error.
class NativeParser {
public:
  NativeParser(ir::NativeLanguage language, std::string_view text, const CompileOptions &options,
               Reporter &reporter, NameTable *names);

  void parse();
  [[nodiscard]] Binder &binder() { return m_binder; }
  [[nodiscard]] NativeInterface takeInterface();

private:
  /// The value that DEFINE or DECLARE gives a name.
  struct Named {
    enum class Kind : std::uint8_t { Unknown, Scalar, Vector, Local } kind = Kind::Unknown;
    ir::Vec4 value = {};
    std::uint16_t local = 0;
    Span declared;
  };

  // parser.cpp: statements, recovery, tokens
  void parseOptions();
  bool parseOption();
  void parseStatement();
  bool unknownStatement(const Token &first);
  [[nodiscard]] Vocabulary vocabulary() const;
  void parseEnd();
  void finish(Span end);
  void bindAllRows(Span where);
  void recover();
  [[nodiscard]] bool beginsStatement(const Token &token) const;
  [[nodiscard]] bool atByte(char byte) const;
  bool acceptByte(char byte);
  bool expectByte(char byte);
  bool expect(TokenKind kind, const char *what, const char *hint = "");
  /// The semicolon of a statement.
  bool endStatement(const char *expected = "';'", std::string hint = {});
  bool unexpected(const char *expected, std::string hint = {});
  [[nodiscard]] bool atWord(std::string_view word) const;
  [[nodiscard]] bool atBinding(std::string_view letter) const;
  [[nodiscard]] std::string_view text(const Token &token) const { return m_tokens.text(token); }
  [[nodiscard]] std::string_view at(Span span) const {
    return m_text.substr(span.begin, span.end - span.begin);
  }
  [[nodiscard]] Span spanFrom(std::uint32_t begin) const { return {begin, m_tokens.lastEnd()}; }
  [[nodiscard]] bool fragment() const { return m_traits.language == ir::NativeLanguage::Fp1; }
  [[nodiscard]] bool statesOnly() const { return m_traits.language == ir::NativeLanguage::Vsp1; }
  [[nodiscard]] std::string header() const { return std::string(ir::headerOf(m_traits.language)); }
  [[nodiscard]] c_like::Dialect dialect() const {
    return fragment() ? c_like::Dialect::OwnFragment : c_like::Dialect::OwnVertex;
  }
  [[nodiscard]] PartTexts parts() const { return partsBehind(m_text, m_behindOpcode); }
  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});
  void note(const Token &name, Access access, SymbolKind kind = SymbolKind::Unknown) {
    if (m_names)
      m_names->add(text(name), name.span, access, kind);
  }

  // instructions.cpp
  bool parseInstruction(const Token &opcode, const Word &word);
  bool expectPart(ir::Opcode op, Part part);
  bool parseOperands(nv::Statement &statement);
  bool parseTest(nv::Test &test);
  bool parseConditionMask(nv::Test &test);
  bool parseTexture(ir::Instruction &instruction);
  bool parseTarget(Span unitSpan, ir::Instruction &instruction);
  bool parseFlow(const Token &opcode, const Word &word);
  bool parseLabel(const Token &name);
  void keep(const nv::Statement &statement, Span opcode);

  // registers.cpp: destinations, and registers that operands use too
  bool parseDestination(ir::Destination &destination);
  bool parseDestinationRegister(ir::Destination &destination);
  bool parseAddressDestination(ir::Destination &destination);
  bool parseResult(ir::Destination &destination);
  bool parseFragmentResult(const Token &name, ir::Output &output);
  bool parseVertexResult(const Token &name, ir::Output &output);
  bool parseWrittenRow(ir::Destination &destination);
  bool parseMask(std::uint8_t &mask);
  bool parseBracketed(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &index);
  bool takeIndex(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &index);
  [[nodiscard]] std::optional<std::uint16_t> temporary(const Token &name);
  [[nodiscard]] std::uint16_t nullRegister(Span where);
  [[nodiscard]] bool isNullRegister(std::string_view word) const;
  [[nodiscard]] std::optional<std::uint16_t> address(const Token &name);
  [[nodiscard]] bool isRegisterName(std::string_view word) const;
  bool notThere(const Token &name, const char *expected);
  void countUnits(std::uint32_t units, Span where);

  // operands.cpp
  bool parseSource(bool scalar, ir::Operand &operand, bool &absolute);
  bool parseBase(ir::Operand &operand, bool &hasSuffix);
  bool parseAttribute(ir::Operand &operand);
  bool parseVertexAttribute(ir::Attribute &attribute, std::uint32_t &index);
  bool parseFragmentAttribute(ir::Attribute &attribute);
  bool parseLocal(ir::Operand &operand);
  bool parseRow(ir::Operand &operand);
  bool parseRelativeRow(ir::Operand &operand);
  bool parseOffset(std::int16_t &offset);
  bool parseAddressComponent(std::uint8_t &component);
  bool parseAddressSource(ir::Operand &operand);
  bool parseSuffix(bool scalar, ir::Swizzle &swizzle, std::uint32_t begin = 0);
  void useParameter(const ir::Operand &operand, Span where);
  void useConstant(const ir::Vec4 &value, Span where);
  void tooManyParameters(Span where);

  // names.cpp: DEFINE, DECLARE and the constants of !!FP1.0
  bool parseDefine();
  bool parseDeclare();
  bool newName(Token &name);
  void declare(const Token &name, const Named &named);
  bool parseValue(Named &named);
  bool parseVector(ir::Vec4 &value);
  bool parseScalar(float &value);
  bool parseNumber(float &value);
  bool parseNamed(const Token &name, ir::Operand &operand, bool &hasSuffix);
  bool parseLiteral(bool negative, ir::Operand &operand);

  const Traits &m_traits;
  std::string_view m_text;
  const Limits &m_limits;
  Reporter &m_reporter;
  NameTable *m_names;
  TokenStream m_tokens;
  Binder m_binder;
  ir::Options m_options;
  NativeInterface m_interface;
  nv::NativeRules m_rules;
  std::vector<nv::Statement> m_statements;

  std::array<std::optional<std::uint16_t>, 96> m_temporaries; ///< R0 to R31, H0 to H63
  std::optional<std::uint16_t> m_nullRegister;
  std::array<std::optional<std::uint16_t>, 2> m_addresses;
  std::unordered_map<std::string_view, Named> m_named;
  std::uint32_t m_behindOpcode = 0; ///< the end of the opcode of the instruction that is read
  nv::Labels m_labels{m_text, m_reporter};
  std::array<std::optional<ir::TexTarget>, 32> m_targets; ///< by image unit

  std::set<std::uint16_t> m_rowsRead, m_rowsWritten;
  std::uint32_t m_units = 0;               ///< register units of !!FP1.0
  std::optional<std::string_view> m_color; ///< the colour that is written: COLR or COLH
  std::set<std::uint16_t> m_results;       ///< rows of Program::outputs that are written
  bool m_writesPosition = false;

  // State of the current statement.
  std::optional<std::uint16_t> m_attribute; ///< the row that it reads
  std::optional<ir::Operand> m_parameter;   ///< the register that it reads
  std::set<float> m_scalars;                ///< those of its constants
};

} // namespace arbiter::fp::native
