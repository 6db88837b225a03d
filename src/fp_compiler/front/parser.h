#pragma once
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/front/bindings/binder.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/nv/labels.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/symbols.h"
#include "fp_compiler/front/words/keywords.h"
#include "fp_compiler/front/words/language.h"
#include "fp_compiler/front/words/names.h"
#include "fp_compiler/front/words/other_words.h"
#include "fp_compiler/front/words/parts.h"
#include "fp_compiler/native_interface.h"

namespace arbiter::fp {

struct ParseResult {
  std::vector<Diagnostic> diagnostics; ///< in text order
  std::optional<ir::Program> program;  ///< empty if there is any error
  ResourceCounts counts;
  NativeInterface native; ///< of NVIDIA's own languages (native/parser.h)
};

/// Parses and checks an ARBfp1.0 (ARB_fragment_program 3.11.2 to 3.11.6) or an ARBvp1.0 program
/// (ARB_vertex_program 2.14.2 to 2.14.5). Time and memory are linear in the text, and there is no
/// recursion.
/// \param names if not null, gets every name of the text; a text with a wrong header is then parsed
/// too, for its names and for more diagnostics
[[nodiscard]] ParseResult parseArbProgram(const ArbLanguage &language, std::string_view text,
                                          const CompileOptions &options,
                                          NameTable *names = nullptr);

/// The parser, with one function for each statement. A function that returns bool returns false
/// after it has reported a syntax error. The statement is then skipped, and parsing continues at
/// the next one. After a semantic error the statement continues.
class Parser {
public:
  /// Begins after the header, which has been checked.
  Parser(const ArbLanguage &language, std::string_view text, const CompileOptions &options,
         Reporter &reporter, std::uint32_t begin, NameTable *names);

  void parse();
  [[nodiscard]] Binder &binder() { return m_binder; }

private:
  /// Whether a binding is in a declaration or in an instruction, where a suffix may follow.
  enum class Place : std::uint8_t { Declaration, Operand };
  /// The rows of a parameter array, or the one row of a single parameter.
  using Rows = std::vector<std::uint16_t>;

  // options.cpp
  void parseOptions();
  bool parseOption(bool late);
  void applyOption(const Token &name);
  void refuseOption(const Token &name);

  // parser.cpp: the program, recovery, tokens
  void parseStatement();
  bool parseStatementBody(const Token &first, const Word &word);
  void parseEnd();
  bool unknownStatement(const Token &first);
  [[nodiscard]] std::string statementHintInC(const Token &first) const;
  void settle(const Token &first);
  bool isNvVariant(std::string_view word) const;
  /// Returns the end of the error that refuses a word of NVIDIA's options. The second function
  /// returns its hint.
  std::string ofNvOptions() const;
  std::string nvOptionsHint(std::string_view word) const;
  bool isForeignStatement(std::string_view word) const;
  void recover();
  bool expect(TokenKind kind, const char *what, const char *hint = "");
  /// The semicolon of a statement.
  bool endStatement(const char *expected = "';'", std::string hint = {});
  /// The same of an instruction, which may have too many operands.
  bool endInstruction(ir::Opcode op) { return endStatement("';'", surplusHint(op)); }
  [[nodiscard]] std::string surplusHint(ir::Opcode op) const;
  [[nodiscard]] Vocabulary vocabulary() const;
  [[nodiscard]] PartTexts parts() const { return partsBehind(m_text, m_behindOpcode); }
  bool unexpected(const char *expected, std::string hint = {});
  bool unexpectedToken(const Token &token, const char *expected, std::string hint = {});
  [[nodiscard]] std::string describe(const Token &token) const;
  [[nodiscard]] std::string_view text(const Token &token) const { return m_tokens.text(token); }
  [[nodiscard]] Word wordOf(const Token &token) const {
    return m_options.nv == ir::NvOption::None ? classify(text(token), m_language)
                                              : nv::classify(text(token), m_language, m_options.nv);
  }
  [[nodiscard]] Word keywordAt() const;
  [[nodiscard]] bool atWord(int ahead, std::string_view word) const;
  [[nodiscard]] Span spanFrom(std::uint32_t begin) const { return {begin, m_tokens.lastEnd()}; }
  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});
  /// Reports a word of the other language. The hint is for a word that has none of its own.
  void foreign(const Token &token, std::string_view what, std::string hint = {});
  /// Adds the name to the table of names, if there is one.
  void note(const Token &name, Access access, SymbolKind kind = SymbolKind::Unknown) {
    if (m_names)
      m_names->add(text(name), name.span, access, kind);
  }
  void noteSkipped(const Token &token);

  // declarations.cpp
  bool parseRegisters(SymbolKind kind);
  bool expectBinding(const Token &name, const char *declaration, const char *binding);
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
  bool parseColorAttribute(Place place, ir::Attribute &attribute);
  bool parseTexCoord(std::uint8_t &index);
  bool parseResultBinding(Place place, std::uint16_t &row);
  bool parseFragmentResult(ir::Output &output);
  bool parseProgramBinding(std::uint32_t begin, bool range, Rows &rows);
  bool parseConstant(bool isSigned, std::uint16_t &row);
  bool parseConstantVector(ir::Vec4 &value);
  bool parseNumber(bool isSigned, float &value);
  bool parseIndex(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &index);
  bool parseOptionalIndex(std::uint32_t limit, DiagnosticId id, const char *what,
                          std::uint32_t &index);
  bool parseBounded(std::uint32_t limit, DiagnosticId id, const char *what, std::uint32_t &value);
  bool unknownWord(const char *what, std::initializer_list<std::string_view> words,
                   std::initializer_list<std::string_view> foreignWords = {});

  // vertex_bindings.cpp: bindings of vertex programs only
  bool parseVertexAttribute(ir::Attribute &attribute);
  bool parseVertexWeight(const Token &word, ir::Attribute &attribute);
  bool parseVertexResult(ir::Output &output);
  bool parseVertexColor(ir::Output &output);
  bool parseTexGen(ir::StateRef &ref);
  bool parseClipPlane(ir::StateRef &ref);
  bool parseClipDistance(ir::Output &output);
  bool parsePoint(ir::StateRef &ref);

  // state_binding.cpp
  bool parseStateBinding(std::uint32_t begin, bool range, Rows &rows);
  bool parseMaterial(ir::StateRef &ref);
  bool parseLight(ir::StateRef &ref);
  bool parseLightModel(ir::StateRef &ref);
  bool parseLightProduct(ir::StateRef &ref);
  bool parseTexEnv(ir::StateRef &ref);
  bool parseFog(ir::StateRef &ref);
  bool parseDepth(ir::StateRef &ref);
  bool parseMatrix(std::uint32_t begin, bool range, Rows &rows);
  bool parseMatrixName(ir::StateRef &ref);
  bool parseMatrixRows(bool range, std::uint32_t &first, std::uint32_t &last);
  bool parseFace(ir::StateRef &ref);

  // instructions.cpp
  bool parseInstruction(const Token &opcode, const Word &word);
  bool expectPart(ir::Opcode op, Part part);
  bool parseDestination(ir::Destination &destination);
  bool parseDestinationRegister(ir::Destination &destination);
  bool parseAddressDestination(ir::Destination &destination);
  bool readOnlyDestination(const Token &first, const Word &word);
  bool parseMask(std::uint8_t &mask);
  bool parseExtendedSwizzle(ir::Instruction &instruction);
  bool parseTexture(ir::Instruction &instruction);
  [[nodiscard]] std::string unitHint() const;
  bool parseTarget(Token &word);

  // operands.cpp
  bool parseSource(bool scalar, ir::Operand &operand);
  bool parseSwzSource(ir::Operand &operand);
  bool parseSourceRegister(ir::Operand &operand);
  bool parseNamedSource(ir::Operand &operand);
  bool parseArrayElement(const Token &name, const Symbol &array, ir::Operand &operand);
  bool parseRelativeElement(const Token &name, const Symbol &array, ir::Operand &operand);
  bool parseAddressComponent();
  bool parseRelativeOffset(std::int16_t &offset);
  bool parseSwizzle(bool scalar, ir::Swizzle &swizzle, std::uint32_t begin = 0);
  [[nodiscard]] std::string suffixHint(std::string_view suffix, bool scalar) const;
  bool undeclared(const Token &name);
  bool skipIndex();

  // nv/parse.cpp: statements of NVIDIA's options
  [[nodiscard]] bool atByte(char byte, int ahead = 0) const;
  bool acceptByte(char byte);
  bool expectByte(char byte);
  [[nodiscard]] bool atSize() const;
  bool parseSized();
  bool parseTest(nv::Test &test);
  bool parseConditionMask(nv::Test &test);
  bool parseNvSource(bool scalar, ir::Operand &operand, bool &absolute);
  bool parseNvSwzSource(ir::Operand &operand, bool &absolute);
  bool parseNvOperands(nv::Statement &statement);
  std::optional<std::uint16_t> readAddressVector(const Token &name);
  bool parseAddressSource(ir::Operand &operand);
  bool parseNvAddressDestination(ir::Destination &destination);
  bool parseNvDestination(nv::Statement &statement);
  void checkSize(const ir::Destination &destination);
  bool parseNvInstruction(const Token &opcode, const Word &word);
  bool parseNvFlow(const Token &opcode, const Word &word);
  bool endBlock(const Token &opcode, const Word &word);
  bool beginLoop(nv::Statement &statement);
  bool parseStack(nv::Statement &statement);
  std::string unknownNvHint(const Token &first) const;
  bool unknownNvStatement(const Token &first);
  bool parseLabel(const Token &name);
  bool atAddress() const;
  bool parseIndexed(std::optional<std::uint16_t> &sequence);
  void indexAttributes(ir::AttributeKind kind, std::uint32_t count);
  void keep(const nv::Statement &statement, Span opcode);
  void finishNv(Span end);

  /// A parameter array. `relative` is its number in the program once an address register has
  /// indexed it.
  struct Array {
    Rows rows;
    std::optional<std::uint16_t> relative;
  };

  const ArbLanguage &m_language;
  /// Limits an index to eight bits, which is how state and attributes are stored. No GL has so many
  /// of them that this matters.
  static std::uint32_t byteLimit(std::uint32_t limit) { return limit < 256 ? limit : 256; }

  std::string_view m_text;
  const Limits &m_limits;
  LimitPolicy m_policy;
  Reporter &m_reporter;
  NameTable *m_names; ///< null where names are not wanted
  TokenStream m_tokens;
  Binder m_binder;
  SymbolTable m_symbols;
  ir::Options m_options;
  std::vector<Array> m_arrays;
  /// A range makes many elements from little text, so the number of elements has its own limit.
  static constexpr std::size_t kMaxArrayEntries = 65536;
  std::size_t m_arrayEntries = 0;
  struct UnitUse {
    bool used = false;
    ir::TexTarget target = ir::TexTarget::Tex2D;
  };
  std::vector<UnitUse> m_units;
  std::uint32_t m_behindOpcode = 0; ///< the end of the opcode of the instruction that is read
  // State for NVIDIA's options.
  std::vector<nv::Statement> m_statements;
  nv::Labels m_labels{m_text, m_reporter};
  std::uint8_t m_addressComponent = 0; ///< the one that was read last
  struct Block {
    ir::Opcode begin = ir::Opcode::If; ///< If, Else, Loop or Rep
    Span where;
  };
  std::vector<Block> m_blocks; ///< those that are open
  nv::Sequences m_sequences;
  std::optional<std::uint16_t> m_texCoords, m_attribs, m_texCoordResults; ///< of m_sequences
  bool m_mayIndex = false;                     ///< a binding may be chosen by an address register
  std::optional<nv::Indexed> m_indexed;        ///< the binding that was read was
  RegisterSize m_size = RegisterSize::Long;    ///< of the declaration
  RegisterSize m_written = RegisterSize::Long; ///< of the destination that was read last
  std::map<std::uint16_t, RegisterSize> m_resultSizes; ///< of results, as they are written
};

} // namespace arbiter::fp
