#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/ati/shader.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/core/reader.h"
#include "fp_compiler/front/words/other_words.h"

/// Parses the text form of ATI fragment shaders (ATI_text_fragment_shader 3.10.1). The printed
/// grammar has gaps; docs/write/ati_fragment_shader.md says how each is read.
namespace arbiter::fp::ati {

inline constexpr std::string_view kHeader = "!!ATIfs1.0";

struct ParseResult {
  std::vector<Diagnostic> diagnostics; ///< in text order
  std::optional<Shader> shader;        ///< empty if there is any error
  /// Pairs count as ALU instructions, SampleMaps as TEX instructions, and passes as indirections.
  /// Registers, declared constants and interpolators are counted too.
  ResourceCounts counts;
};

/// Parses and checks an !!ATIfs1.0 text. Time is linear in the text. Memory is constant except for
/// the diagnostics, and there is no recursion. Of the limits only those of parameters and of
/// fixed-function texture units apply. Other sizes are part of the grammar, so every LimitPolicy
/// enforces them.
/// \param names as in parseArbProgram(): registers are listed as temporaries, constants as
/// parameters
[[nodiscard]] ParseResult parse(std::string_view text, const CompileOptions &options,
                                NameTable *names = nullptr);

/// The parser of a text.
class Parser : Reader {
public:
  Parser(const SourceText &source, const Limits &limits)
      : Reader(source, Words::Suffixes), m_limits(limits) {}

  void run();
  [[nodiscard]] const Shader &shader() const { return m_shader; }
  [[nodiscard]] ResourceCounts counts() const;

private:
  // parser.cpp: blocks
  void parsePass(bool prelim);
  void parsePassStatement();
  void closePass();
  void parseEnd();
  [[nodiscard]] static Vocabulary vocabulary();
  void unknownStatement(const Token &first);
  [[nodiscard]] bool endsStatement(const Token &token) const override;
  [[nodiscard]] std::string hintAt(const Token &token) const override;

  // constants.cpp
  void parseConstants();
  bool parseConstant();
  bool parseConstantName(const char *what, Token &token, std::uint8_t &index);
  bool parseParameterBinding(Constant &constant);
  bool parseLiteral(Constant &constant);
  bool parseNormalizedFloat(float &value);

  // setups.cpp
  bool parseSetup(const Token &first, SetupKind kind);
  bool parseSetupSource(Setup &setup);
  bool parseCoordinates(Setup &setup, const Token &source);
  bool parseRegister(const char *what, Token &token, std::uint8_t &index);
  bool isRegister(const Token &token, Access access, std::uint8_t &index);
  void useTexCoord(const Setup &setup, const Token &source, const Token &selector);

  // instructions.cpp
  struct Statement {
    Operation operation;
    std::uint8_t mask = 0xF; ///< bit 0 = r to bit 3 = a
    Span maskSpan;           ///< of the mask, or of the destination without one
    Span span;
  };
  bool parseInstruction(const Token &first, Op op);
  bool parseDestination(Statement &statement);
  bool parseArguments(Statement &statement);
  bool missingArgument(Op op, int at);
  bool parseArgument(const Statement &statement, int at, Argument &argument);
  bool parseSource(Argument &argument, Token &token);
  bool parseArgumentSuffixes(Argument &argument);
  void checkSource(const Statement &statement, int at, const Argument &argument, Span span);
  void checkPairing(const Statement &statement);
  void addToPairs(const Statement &statement);

  const Limits &m_limits;
  Shader m_shader;

  std::array<bool, kConstants> m_declared = {};
  std::array<bool, kRegisters> m_registersUsed = {};
  std::array<bool, 2> m_colorsUsed = {};
  /// Whether a texture coordinate set is used with r or with q as its third component (rule 8).
  enum class Third : std::uint8_t { Unused, R, Q };
  std::array<Third, kTexCoords> m_thirds = {};

  // State of the current pass.
  Pass *m_pass = nullptr;
  bool m_prelim = false;
  bool m_hasInstructions = false;
  int m_pairs = 0; ///< also those beyond the limit
  /// True if the last statement wrote only colour, so that an alpha instruction completes its pair.
  bool m_openPair = false;
  bool m_openDot4 = false; ///< and it was a DOT4
};

} // namespace arbiter::fp::ati
