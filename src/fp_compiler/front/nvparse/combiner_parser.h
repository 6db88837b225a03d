#pragma once
#include <array>
#include <optional>

#include "fp_compiler/front/nvparse/reader.h"
#include "fp_compiler/front/nvparse/words.h"

namespace arbiter::fp::nvparse {

/// Parses the text after !!RC1.0: constants, general stages, the final combiner. There is one
/// function for each statement.
class CombinerParser : Reader {
public:
  CombinerParser(const SourceText &source, const CompileOptions &options)
      : Reader(source, options) {}

  void run(combiners::State &state, texture_shader::Values &values);

private:
  using Usage = combiners::Usage;
  using Constant = std::optional<ir::Vec4>;
  using Pair = std::array<Constant, 2>;

  // combiner_parser.cpp: the order of statements, constants, stages
  void parseTop();
  bool parseFinalStatement();
  bool parseConstant(Pair &to, const char *where);
  void parseStage();
  void parseStageBody(combiners::Stage &stage, Pair &own);
  bool endsBlock(bool empty, const char *message, const char *hint);
  void finish(texture_shader::Values &values);

  // combiner_portion.cpp
  void parsePortion(combiners::Portion &portion, Usage usage);
  bool parsePortionStatement(combiners::Portion &portion, Usage usage);
  bool parseScale(combiners::Portion &portion, const Token &word);
  bool parseOutput(Usage usage, combiners::Register &to, Span &span);
  bool parseProduct(combiners::Portion &portion, Usage usage, combiners::Register to, Span span);
  void checkOutputs(const combiners::Portion &portion, combiners::Register to, Span span);
  bool parseMapped(Usage usage, combiners::Input &input);

  // combiner_final.cpp
  bool parseFinalInput(Usage usage, combiners::Input &input);
  bool parseFinalProduct();
  bool parseColor(const Token &out);
  bool parseLerp();
  bool parseAlpha(const Token &out);
  void checkFinalInput(const combiners::Input &input, Usage usage, const Token &word);

  /// A register with its components, as an input names it.
  struct Named {
    combiners::Register name = combiners::Register::Zero;
    bool one = false;
    std::optional<Usage> usage; ///< as written
    Token word;
    Span span; ///< with the components
  };
  bool parseRegister(Named &named, Access access);
  [[nodiscard]] bool atComponents() const;

  combiners::State m_state;
  Pair m_constants;                           ///< for every stage
  std::array<Pair, combiners::kStages> m_own; ///< of each stage
  int m_stages = 0;                           ///< also those beyond the limit
  bool m_final = false;                       ///< a statement of the final combiner was there
  bool m_perStage = false, m_clamps = false;  ///< the statements of their names
  bool m_hasProduct = false, m_hasColor = false, m_hasAlpha = false;
  std::optional<Span> m_readsProduct; ///< where final_product is read first
  int m_products = 0;                 ///< of the portion at hand
  bool m_hasSum = false, m_hasScale = false;
};

} // namespace arbiter::fp::nvparse
