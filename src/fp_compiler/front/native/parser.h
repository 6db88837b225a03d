#pragma once
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "fp_compiler/front/assembly/parser.h"
#include "fp_compiler/front/native/language.h"
#include "fp_compiler/front/nv/lowering.h"
#include "fp_compiler/front/words/numeral.h"

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

/// The parser of a program.
class NativeParser : public AssemblyParser {
public:
  NativeParser(const Traits &traits, const SourceText &source, const CompileOptions &options);

  [[nodiscard]] NativeInterface takeInterface();

private:
  /// The value that DEFINE or DECLARE gives a name.
  struct Named {
    enum class Kind : std::uint8_t { Unknown, Scalar, Vector, Local } kind = Kind::Unknown;
    ir::Vec4 value = {};
    std::uint16_t local = 0;
    Span declared;
  };

  // parser.cpp: statements
  void applyOption(const Token &name) override;
  void parseStatement() override;
  bool unknownStatement(const Token &first);
  [[nodiscard]] Vocabulary statementWords() const override;
  [[nodiscard]] bool offers(ir::Opcode op) const override {
    return nv::offers(m_traits.language, op);
  }
  void finish(Span end) override;
  void bindAllRows(Span where);
  void skipped(const Token &token) override;
  [[nodiscard]] std::string_view ownBytes() const override { return "|():"; }
  [[nodiscard]] Word wordOf(std::string_view identifier) const override {
    return nv::classify(identifier, m_traits.language);
  }
  [[nodiscard]] std::optional<ir::Opcode> baseOf(std::string_view identifier) const override {
    return nv::baseOf(identifier, m_traits.language);
  }
  /// Returns whether a name may be a word that begins statements (newName()).
  [[nodiscard]] bool endsParts(const Token &word) const override {
    return endsStatement(word) && !m_named.find(text(word));
  }
  [[nodiscard]] bool hasConditions() const override { return m_traits.conditions; }
  [[nodiscard]] bool hasAddressVectors() const override { return m_traits.addressVectors; }
  [[nodiscard]] bool hasPlusSigns() const override { return m_traits.plusSigns; }
  [[nodiscard]] bool killsByTest() const override { return true; }
  [[nodiscard]] bool atBinding(std::string_view letter) const;
  [[nodiscard]] bool fragment() const { return m_traits.language == ir::NativeLanguage::Fp1; }
  [[nodiscard]] bool statesOnly() const { return m_traits.language == ir::NativeLanguage::Vsp1; }
  [[nodiscard]] std::string header() const { return std::string(ir::headerOf(m_traits.language)); }
  /// Returns the number of a texture coordinate set that is named TEX0 to TEX7.
  [[nodiscard]] std::optional<std::uint8_t> takeTexCoord(const Token &name);

  // registers.cpp: destinations, and registers that operands use too
  bool parseDestinationRegister(ir::Destination &destination) override;
  bool parseResult(ir::Destination &destination);
  bool parseFragmentResult(const Token &name, ir::Output &output);
  bool parseVertexResult(const Token &name, ir::Output &output);
  bool parseWrittenRow(ir::Destination &destination);
  bool parseBounded(std::uint32_t limit, DiagnosticId id, const char *what,
                    std::uint32_t &value) override;
  bool parseTexture(ir::Instruction &instruction) override;
  [[nodiscard]] std::optional<std::uint16_t> temporary(const Token &name);
  [[nodiscard]] std::uint16_t nullRegister(Span where);
  [[nodiscard]] bool isNullRegister(std::string_view word) const;
  [[nodiscard]] std::optional<std::uint16_t> address(const Token &name);
  std::optional<std::uint16_t> takeAddress(Access access) override;
  [[nodiscard]] bool isRegisterName(std::string_view word) const;
  bool notThere(const Token &name, const char *expected);
  void countUnits(std::uint32_t units, Span where);

  // operands.cpp
  bool parseBase(Base &base) override;
  bool parseRegister(Base &base);
  bool parseAttribute(ir::Operand &operand);
  bool parseVertexAttribute(ir::Attribute &attribute, std::uint32_t &index);
  bool parseFragmentAttribute(ir::Attribute &attribute);
  bool parseLocal(ir::Operand &operand);
  bool parseRow(ir::Operand &operand);
  bool parseRelativeRow(ir::Operand &operand);
  void useParameter(const ir::Operand &operand, Span where);
  void useConstant(ir::Operand &operand, const ir::Vec4 &value, Span where);
  void tooManyParameters(Span where);

  // names.cpp: DEFINE, DECLARE and the constants of !!FP1.0
  bool parseDefine();
  bool parseDeclare();
  bool newName(Token &name);
  bool parseValue(Named &named);
  bool parseScalar(float &value) override;
  [[nodiscard]] const Named *takeNamed(Named::Kind kind);
  bool parseNamed(const Token &name, Base &base);

  const Traits &m_traits;
  NativeInterface m_interface;
  nv::NativeRules m_rules;

  std::array<std::optional<std::uint16_t>, 96> m_temporaries; ///< R0 to R31, H0 to H63
  std::optional<std::uint16_t> m_nullRegister;
  std::array<std::optional<std::uint16_t>, 2> m_addresses;
  Declarations<Named> m_named;
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
