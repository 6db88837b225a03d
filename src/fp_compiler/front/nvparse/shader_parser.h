#pragma once
#include <array>

#include "fp_compiler/front/nvparse/reader.h"
#include "fp_compiler/front/nvparse/words.h"

namespace arbiter::fp::nvparse {

/// Parses the text after !!TS1.0: one stage for each texture unit.
class ShaderParser : Reader {
public:
  ShaderParser(const SourceText &source, const CompileOptions &options) : Reader(source, options) {}

  /// Parses up to the end of the text, or to a byte that begins no word, such as the next header.
  /// Returns the token there.
  Token run(texture_shader::State &state, texture_shader::Values &values);

private:
  bool parseStage();
  bool parseArguments(const OperationWord &row, texture_shader::Stage &stage);
  bool parseCull(texture_shader::Stage &stage);
  bool parsePrevious(texture_shader::Stage &stage);
  bool parseMapped(texture_shader::Stage &stage);
  /// Parses the numbers after a texture. Without any, the application sets them.
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
