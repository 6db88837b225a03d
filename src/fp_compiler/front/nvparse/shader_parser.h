#pragma once
#include <array>

#include "fp_compiler/front/nvparse/reader.h"
#include "fp_compiler/front/nvparse/words.h"

namespace arbiter::fp::nvparse {

/// Parses what follows !!TS1.0: one stage for each texture unit.
class ShaderParser : Reader {
public:
  ShaderParser(WordTokens &tokens, std::string_view text, const CompileOptions &options,
               Reporter &reporter, NameTable *names)
      : Reader(tokens, text, options, reporter, names) {}

  /// Up to the end of the text, or to a byte that begins no word: the header of what follows.
  void run(texture_shader::State &state, texture_shader::Values &values);

private:
  bool parseStage();
  bool parseArguments(const OperationWord &row, texture_shader::Stage &stage);
  bool parseCull(texture_shader::Stage &stage);
  bool parsePrevious(texture_shader::Stage &stage);
  bool parseMapped(texture_shader::Stage &stage);
  /// The numbers behind a texture; none at all leave them to the application.
  bool parseNumbers(const OperationWord &row);
  void checkRun(const OperationWord &row, Span span);
  void checkRunEnd(Span span);
  void checkConsistency();

  texture_shader::State m_state;
  texture_shader::Values m_values;
  std::array<Span, texture_shader::kUnits> m_spans{};
  int m_unit = 0;                          ///< the stage at hand, also beyond the limit
  const OperationWord *m_before = nullptr; ///< the stage before it
};

} // namespace arbiter::fp::nvparse
