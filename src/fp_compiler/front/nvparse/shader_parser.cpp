#include "fp_compiler/front/nvparse/shader_parser.h"

#include <algorithm>
#include <vector>

#include "fp_compiler/front/c_like/statements.h"
#include "fp_compiler/texture_shader/operations.h"
#include "util/suggest.h"

namespace arbiter::fp::nvparse {

using texture_shader::Row;
using texture_shader::Stage;

Token ShaderParser::run(texture_shader::State &state, texture_shader::Values &values) {
  // If texture shaders are not offered at all, the header has the error.
  const Limits &limits = m_options.limits;
  m_state.units = limits.textureShaders == 0
                      ? std::uint8_t(texture_shader::kUnits)
                      : std::uint8_t(std::clamp(limits.textureUnits, 1u,
                                                std::uint32_t(texture_shader::kUnits)));
  while (!at(TokenKind::EndOfText) && !m_reporter.full()) {
    if (atByte('!'))
      break;
    if (!parseStage()) {
      recover();
      m_tokens.accept(TokenKind::CloseBrace); // there are no blocks
    }
  }
  checkRunEnd({m_tokens.lastEnd(), m_tokens.lastEnd()});
  m_state.textures = assumedTextures(m_state);
  checkConsistency();
  state = m_state;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (m_values[i])
      values[i] = m_values[i];
  return m_tokens.peek();
}

bool ShaderParser::parseStage() {
  if (!atStatement("a stage, such as texture_2d();"))
    return false;
  const Token word = m_tokens.next();
  const OperationWord *const row = operationOf(text(word));
  if (!row) {
    std::vector<std::string_view> words;
    for (const OperationWord &each : operationWords())
      words.push_back(each.word);
    error(DiagnosticId::TsOperation, word.span, "there is no stage " + quote(text(word)),
          didYouMean(text(word), words, c_like::hintFor(m_text, word.span)));
    ++m_unit;
    return false;
  }
  if (m_unit == m_state.units)
    error(DiagnosticId::LimitShaderUnits, word.span,
          "a stage for texture unit " + std::to_string(m_unit) + ": there are " +
              std::to_string(m_state.units) + " units");
  if (row->extension > m_options.limits.textureShaders && m_options.limits.textureShaders != 0)
    limit(DiagnosticId::LimitShaders, word.span,
          std::string(row->word) + " needs NV_texture_shader" + std::to_string(row->extension));
  checkRun(*row, word.span);
  Stage stage;
  stage.operation = row->operation;
  const auto first = texture_shader::infoOf(row->operation).firstUnit;
  if (m_unit < first)
    error(DiagnosticId::TsPrevious, word.span,
          std::string(row->word) + " cannot be the stage of unit " + std::to_string(m_unit),
          "the first unit that can have it is " + std::to_string(first));
  const bool whole = parseArguments(*row, stage);
  if (m_unit < m_state.units) {
    m_state.stages[std::size_t(m_unit)] = stage;
    m_spans[std::size_t(m_unit)] = {word.span.begin, m_tokens.lastEnd()};
  }
  ++m_unit;
  m_before = row;
  return whole && endStatement();
}

/// Reports words of a run that do not follow each other.
void ShaderParser::checkRun(const OperationWord &row, Span span) {
  const auto follows = [&] {
    return m_before && m_before->run() == row.run() && m_before->stage + 1 == row.stage;
  };
  if (row.stage > 1 && !follows())
    error(DiagnosticId::TsRun, span,
          std::string(row.word) + " does not stand behind " + std::string(row.run()) +
              std::to_string(row.stage - 1) + "of" + std::to_string(row.stages));
  else if (row.stage == 1)
    checkRunEnd(span);
}

void ShaderParser::checkRunEnd(Span span) {
  if (m_before && m_before->stage < m_before->stages)
    error(DiagnosticId::TsRun, span,
          "expected " + std::string(m_before->run()) + std::to_string(m_before->stage + 1) + "of" +
              std::to_string(m_before->stages),
          "the stages of a run follow each other");
  m_before = nullptr;
}

bool ShaderParser::parseArguments(const OperationWord &row, Stage &stage) {
  if (!expect(TokenKind::OpenParen, "'('"))
    return false;
  switch (row.arguments) {
  case Arguments::None:
    break;
  case Arguments::Cull:
    if (!parseCull(stage))
      return false;
    break;
  case Arguments::Previous:
  case Arguments::Matrix:
  case Arguments::Scale:
    if (!parsePrevious(stage))
      return false;
    break;
  case Arguments::Dot:
  case Arguments::Eye:
    if (!parseMapped(stage))
      return false;
    break;
  }
  return parseNumbers(row) && expect(TokenKind::CloseParen, "')'");
}

bool ShaderParser::parseCull(Stage &stage) {
  for (int i = 0; i < 4; ++i) {
    const bool less = atWord("LESS_THAN_ZERO");
    if (!less && !atWord("GEQUAL_TO_ZERO"))
      return unknownWord("GEQUAL_TO_ZERO or LESS_THAN_ZERO", {"GEQUAL_TO_ZERO", "LESS_THAN_ZERO"});
    m_tokens.next();
    stage.cullLess |= std::uint8_t(less ? 1u << unsigned(i) : 0u);
    if (i < 3 && !expect(TokenKind::Comma, "','", "one comparison for each of s, t, r and q"))
      return false;
  }
  return true;
}

bool ShaderParser::parsePrevious(Stage &stage) {
  constexpr const char *kWhat = "a texture, tex0 or another of a stage before this one";
  const auto named = at(TokenKind::Identifier) ? registerOf(text(m_tokens.peek()))
                                               : std::optional<NamedRegister>{};
  const int unit = named ? combiners::textureUnit(named->name) : -1;
  if (unit < 0)
    return unexpected(kWhat);
  const Token word = m_tokens.next();
  note(word, Access::Read, SymbolKind::Temporary);
  if (unit >= m_unit && m_unit != 0)
    error(DiagnosticId::TsPrevious, word.span,
          "the stage of unit " + std::to_string(m_unit) + " reads " + std::string(text(word)) +
              ", which is not before it",
          "a stage reads what the stage of a lower unit gives");
  stage.previous = std::uint8_t(unit);
  return true;
}

bool ShaderParser::parseMapped(Stage &stage) {
  const bool expands = acceptWord("expand");
  const bool forces = !expands && acceptWord("force_blue_to_one");
  if (expands)
    stage.mapping = texture_shader::Mapping::ExpandNormal;
  if (forces) {
    stage.mapping = texture_shader::Mapping::ForceBlueToOne;
    if (m_options.limits.textureShaders < 3 && m_options.limits.textureShaders != 0)
      limit(DiagnosticId::LimitShaders, {m_tokens.lastEnd() - 17, m_tokens.lastEnd()},
            "force_blue_to_one() needs NV_texture_shader3");
  }
  if (!expands && !forces)
    return parsePrevious(stage);
  return expect(TokenKind::OpenParen, "'('") && parsePrevious(stage) &&
         expect(TokenKind::CloseParen, "')'");
}

bool ShaderParser::parseNumbers(const OperationWord &row) {
  const std::size_t count = row.arguments == Arguments::Matrix  ? 4
                            : row.arguments == Arguments::Scale ? 6
                            : row.arguments == Arguments::Eye   ? 3
                                                                : 0;
  if (count == 0 || at(TokenKind::CloseParen))
    return true;
  std::array<float, 6> numbers{};
  for (std::size_t i = 0; i < count; ++i)
    if (!expect(TokenKind::Comma, "','",
                "this stage takes " + std::to_string(count) + " numbers behind the texture") ||
        !parseNumber(numbers[i]))
      return false;
  // In a run, the eye vector belongs to the last stage.
  const int unit = row.arguments == Arguments::Eye ? m_unit + row.stages - 1 : m_unit;
  if (unit >= m_state.units)
    return true;
  const auto set = [&](Row which, const ir::Vec4 &value) {
    m_values[std::size_t(texture_shader::parameter(unit, which))] = value;
  };
  if (row.arguments == Arguments::Eye)
    set(Row::Eye, {numbers[0], numbers[1], numbers[2], 0});
  else
    set(Row::Matrix, {numbers[0], numbers[1], numbers[2], numbers[3]});
  if (row.arguments == Arguments::Scale)
    set(Row::ScaleBias, {numbers[4], numbers[5], 0, 0});
  return true;
}

void ShaderParser::checkConsistency() {
  if (m_reporter.hasErrors())
    return;
  const std::uint32_t consistent = texture_shader::consistentStages(m_state);
  for (int unit = 0; unit < m_state.units; ++unit)
    if ((consistent >> unit & 1u) == 0)
      warning(DiagnosticId::TsInconsistent, m_spans[std::size_t(unit)],
              "the stage of unit " + std::to_string(unit) + " is not consistent, and does nothing",
              "it reads a stage that gives no result of the kind, or its run is not whole");
}

} // namespace arbiter::fp::nvparse
