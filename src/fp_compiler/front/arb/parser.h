#pragma once
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/front/assembly/parser.h"
#include "fp_compiler/front/symbols.h"
#include "fp_compiler/front/words/language.h"

namespace arbiter::fp {

/// Parses and checks an ARBfp1.0 (ARB_fragment_program 3.11.2 to 3.11.6) or an ARBvp1.0 program
/// (ARB_vertex_program 2.14.2 to 2.14.5). Time and memory are linear in the text, and there is no
/// recursion.
/// \param names if not null, gets every name of the text; a text with a wrong header is then parsed
/// too, for its names and for more diagnostics
[[nodiscard]] ParseResult parseArbProgram(const ArbLanguage &language, std::string_view text,
                                          const CompileOptions &options,
                                          NameTable *names = nullptr);

/// The parser of an ARB program, also under NVIDIA's options.
class Parser : public AssemblyParser {
public:
  /// Begins after the header, which has been checked.
  Parser(const ArbLanguage &language, const SourceText &source, const CompileOptions &options);

private:
  /// Whether a binding is in a declaration or in an instruction, where a suffix may follow.
  enum class Place : std::uint8_t { Declaration, Operand };
  /// The rows of a parameter array, or the one row of a single parameter.
  using Rows = std::vector<std::uint16_t>;

  // options.cpp
  void applyOption(const Token &name) override;
  void refuseOption(const Token &name);

  // parser.cpp: the program, recovery
  void parseStatement() override;
  bool parseStatementBody(const Token &first, const Word &word);
  bool unknownStatement(const Token &first);
  void settle(const Token &first);
  bool isNvVariant(std::string_view word) const;
  /// Returns the end of the error that refuses a word of NVIDIA's options. The second function
  /// returns its hint.
  std::string ofNvOptions() const;
  std::string nvOptionsHint(std::string_view word) const;
  bool isForeignStatement(std::string_view word) const;
  [[nodiscard]] Vocabulary statementWords() const override;
  [[nodiscard]] bool offers(ir::Opcode op) const override;
  bool unexpectedToken(const Token &token, const char *expected, std::string hint = {}) override;
  [[nodiscard]] std::string_view ownBytes() const override { return isNv() ? "|():" : ""; }
  [[nodiscard]] Word wordOf(std::string_view identifier) const override;
  [[nodiscard]] std::optional<ir::Opcode> baseOf(std::string_view identifier) const override {
    return nv::baseOf(identifier, m_language, m_options.nv);
  }
  [[nodiscard]] bool isFree(const Token &token) const; ///< an identifier, and no reserved word
  [[nodiscard]] bool isVertex() const { return m_language.language == ir::Language::ArbVertex; }
  [[nodiscard]] bool isNv() const { return m_options.nv != ir::NvOption::None; }
  [[nodiscard]] bool isSecondNv() const { return m_options.nv == ir::NvOption::Second; }
  /// Reports a word of the other language. The hint is for a word that has none of its own.
  void foreign(const Token &token, std::string_view what, std::string hint = {});
  void skipped(const Token &token) override;

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
  bool parseOptionalIndex(std::uint32_t limit, DiagnosticId id, const char *what,
                          std::uint32_t &index);
  bool parseBounded(std::uint32_t limit, DiagnosticId id, const char *what,
                    std::uint32_t &value) override;
  bool parseRange(std::uint32_t limit, DiagnosticId id, const char *what, bool range,
                  std::uint32_t &first, std::uint32_t &last);
  bool parseParameter(bool range, Rows &rows);
  bool parseIndexedAttribute(std::optional<std::uint16_t> &sequence, ir::AttributeKind kind,
                             std::uint32_t count);
  bool unknownWord(const char *what, const std::vector<std::string_view> &words,
                   const std::vector<std::string_view> &foreignWords = {});

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
  struct NamedItem {
    std::string_view word;
    ir::StateItem item;
  };
  bool parseItem(const char *what, std::initializer_list<NamedItem> items, ir::StateRef &ref);
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
  bool parseFace(ir::StateRef &ref);

  // instructions.cpp
  bool parseDestinationRegister(ir::Destination &destination) override;
  bool readOnlyDestination(const Token &first, const Word &word);
  bool parseExtendedSwizzle(ir::Instruction &instruction) override;
  bool parseTexture(ir::Instruction &instruction) override;
  [[nodiscard]] std::string unitHint() const;

  // operands.cpp
  bool parseOperand(nv::Statement &statement, int number) override;
  bool parseBase(Base &base) override;
  bool parseSwzSource(ir::Operand &operand);
  bool parseSourceRegister(ir::Operand &operand);
  bool parseNamedSource(ir::Operand &operand);
  bool parseArrayElement(const Token &name, const Symbol &array, ir::Operand &operand);
  bool parseRelativeElement(const Token &name, const Symbol &array, ir::Operand &operand);
  bool parseRelativeOffset(std::int16_t &offset);
  std::optional<std::uint16_t> takeAddress(Access access) override;
  std::optional<std::uint16_t> addressOf(const Token &name, Access access, const char *hint);
  [[nodiscard]] std::string suffixHint(std::string_view suffix, bool scalar) const override;
  bool undeclared(const Token &name);
  bool skipIndex();

  // nv_statements.cpp: statements of NVIDIA's options
  [[nodiscard]] bool hasConditions() const override { return isNv(); }
  [[nodiscard]] bool hasSecondCondition() const override { return isVertex() && isSecondNv(); }
  [[nodiscard]] bool hasAddressVectors() const override { return isNv(); }
  [[nodiscard]] bool killsByTest() const override;
  [[nodiscard]] bool atLabel() const override { return isFree(m_tokens.peek()); }
  [[nodiscard]] bool atSize() const;
  bool parseSized();
  bool parseDestinationPart(nv::Statement &statement) override;
  void checkSize(const ir::Destination &destination);
  [[nodiscard]] std::string laterOption(std::string_view word) const;
  bool unknownNvStatement(const Token &first);

  // nv_flow.cpp
  bool parseBlockLabel(const Token &name);
  bool endBlock(const Token &opcode, ir::Opcode op);
  bool beginLoop(nv::Statement &statement);
  bool parseStack(nv::Statement &statement);
  bool parseFlowParts(nv::Statement &statement, const Token &opcode) override;
  [[nodiscard]] bool atAddress() const;
  bool parseIndexed(std::optional<std::uint16_t> &sequence, std::uint32_t count,
                    const std::function<std::uint16_t(std::uint8_t)> &bind);
  void finish(Span end) override;

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

  LimitPolicy m_policy;
  SymbolTable m_symbols;
  std::vector<Array> m_arrays;
  /// A range makes many elements from little text, so the number of elements has its own limit.
  static constexpr std::size_t kMaxArrayEntries = 65536;
  std::size_t m_arrayEntries = 0;
  struct UnitUse {
    bool used = false;
    ir::TexTarget target = ir::TexTarget::Tex2D;
  };
  std::vector<UnitUse> m_units;
  // State for NVIDIA's options.
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
