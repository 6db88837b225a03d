#include "fp_compiler/front/nvparse/combiner_parser.h"

#include <algorithm>

#include "fp_compiler/front/c_like/statements.h"
#include "util/suggest.h"

namespace arbiter::fp::nvparse {

using combiners::Mapping;
using combiners::Portion;
using combiners::Register;
using combiners::Stage;

namespace {

/// Returns a portion that writes nothing, for one that the text does not have.
Portion nothing(combiners::Usage usage) {
  Portion portion = combiners::initialPortion(usage);
  portion.inputs.fill({Register::Zero, Mapping::UnsignedIdentity, usage});
  portion.sum = Register::Discard;
  return portion;
}

} // namespace

void CombinerParser::run(combiners::State &state, texture_shader::Values &values) {
  for (std::size_t v = 0; v < m_state.finals.size(); ++v)
    m_state.finals[v] = {Register::Zero, Mapping::UnsignedIdentity,
                         v == 6 ? Usage::Alpha : Usage::Rgb};
  m_state.sumClamp = false;
  while (!at(TokenKind::EndOfText) && !m_reporter.full())
    parseTop();
  finish(values);
  state = m_state;
}

void CombinerParser::parseTop() {
  if (at(TokenKind::OpenBrace))
    return parseStage();
  if (at(TokenKind::CloseBrace)) {
    unexpected("a stage or out.rgb", "no block is open here");
    m_tokens.next();
    return;
  }
  if (!parseFinalStatement())
    recover();
}

/// Parses a statement outside of stages.
bool CombinerParser::parseFinalStatement() {
  constexpr const char *kWhat = "a stage, a constant or the final combiner";
  if (!atStatement(kWhat))
    return false;
  const std::string_view word = text(m_tokens.peek());
  if (word == "const0" || word == "const1") {
    if (m_stages != 0 || m_final)
      error(DiagnosticId::RcOrder, m_tokens.peek().span,
            "a constant for every stage stands before the first one",
            "move it up, or into the stage that it is for");
    return parseConstant(m_constants, "the text");
  }
  const Token first = m_tokens.next();
  if (word == "per_stage_constants") {
    m_perStage = true;
    return parseEmpty() && endStatement();
  }
  m_final = true;
  if (word == "clamp_color_sum") {
    if (m_clamps)
      error(DiagnosticId::RcTwice, first.span, "clamp_color_sum() stands here a second time");
    m_clamps = m_state.sumClamp = true;
    return parseEmpty() && endStatement();
  }
  if (word == "final_product") {
    if (m_hasProduct)
      error(DiagnosticId::RcTwice, first.span, "final_product is made a second time");
    m_hasProduct = true;
    return parseFinalProduct();
  }
  if (word == "out" && m_tokens.accept(TokenKind::Dot)) {
    if (acceptWord("rgb"))
      return parseColor(first);
    if (acceptWord("a"))
      return parseAlpha(first);
    return unknownWord("rgb or a", {"rgb", "a"});
  }
  m_final = false;
  std::string hint = "the final combiner writes out.rgb and out.a, stages stand in braces";
  if (registerOf(word))
    hint = "only a stage writes this: { rgb { ... } alpha { ... } }";
  else if (const std::string named = c_like::hintFor(m_text, first.span); !named.empty())
    hint = named;
  error(DiagnosticId::Syntax, first.span,
        "expected " + std::string(kWhat) + ", found " + describe(m_text, first),
        didYouMean(
            word,
            {"const0", "const1", "out", "final_product", "clamp_color_sum", "per_stage_constants"},
            std::move(hint)));
  return false;
}

bool CombinerParser::parseConstant(Pair &to, const char *where) {
  const Token name = m_tokens.next();
  note(name, Access::Declare, SymbolKind::Parameter);
  Constant &constant = to[std::size_t(text(name).back() - '0')];
  if (constant)
    error(DiagnosticId::RcTwice, name.span,
          std::string(text(name)) + " is set a second time in " + where);
  if (!expect(TokenKind::Equals, "'='") || !expect(TokenKind::OpenParen, "'('"))
    return false;
  ir::Vec4 color{};
  const std::uint32_t begin = m_tokens.peek().span.begin;
  for (std::size_t i = 0; i < color.size(); ++i)
    if (!parseNumber(color[i]) ||
        !expect(i < 3 ? TokenKind::Comma : TokenKind::CloseParen, i < 3 ? "','" : "')'",
                "a constant is of four numbers: red, green, blue, alpha"))
      return false;
  ir::Vec4 clamped = color;
  for (float &c : clamped)
    c = std::clamp(c, 0.0f, 1.0f);
  if (clamped != color)
    warning(DiagnosticId::RcRange, {begin, m_tokens.lastEnd() - 1},
            "a component outside 0.0 to 1.0, to which constants are clamped",
            "scale the constant, and the result by scale_by_two()");
  constant = clamped;
  return endStatement();
}

void CombinerParser::parseStage() {
  const Token brace = m_tokens.next();
  if (m_final)
    error(DiagnosticId::RcOrder, brace.span, "a stage behind the final combiner",
          "stages stand before out.rgb, out.a, final_product and clamp_color_sum()");
  const auto most = std::min(m_options.limits.generalCombiners, std::uint32_t(combiners::kStages));
  Stage beyond;
  Pair own;
  const bool fits = m_stages < combiners::kStages;
  // The limit is reported once. If combiners are not offered at all, the header has the error.
  if (m_stages == int(most) && most != 0)
    (fits ? limit(DiagnosticId::LimitCombiners, brace.span,
                  "more than " + std::to_string(most) + " general stages",
                  "draw in two passes, or join stages")
          : error(DiagnosticId::LimitCombiners, brace.span,
                  "more than " + std::to_string(most) + " general stages",
                  "register combiners have no more"));
  else if (m_stages == combiners::kStages)
    error(DiagnosticId::LimitCombiners, brace.span, "more than 8 general stages",
          "register combiners have no more");
  const auto at = std::size_t(std::min(m_stages, combiners::kStages - 1));
  ++m_stages;
  parseStageBody(fits ? m_state.stages[at] : beyond, fits ? m_own[at] : own);
}

void CombinerParser::parseStageBody(Stage &stage, Pair &own) {
  stage = {nothing(Usage::Rgb), nothing(Usage::Alpha)};
  bool rgb = false, alpha = false;
  while (!m_reporter.full()) {
    const Token &token = m_tokens.peek();
    const std::string_view word = text(token);
    if (endsBlock(!rgb && !alpha, "a stage without rgb { } and alpha { }", "leave the stage out"))
      return;
    if (atWord("const0") || atWord("const1")) {
      if (rgb || alpha)
        error(DiagnosticId::RcOrder, token.span, "a stage's constants stand before its blocks");
      if (m_options.limits.perStageConstants == 0 && m_options.limits.generalCombiners != 0)
        limit(DiagnosticId::LimitStageConstants, token.span,
              "a stage's own constant needs NV_register_combiners2",
              "set it before the first stage, for all of them");
      if (!parseConstant(own, "the stage"))
        recover();
      continue;
    }
    if (atWord("rgb") || atWord("alpha")) {
      const bool isAlpha = word == "alpha";
      bool &seen = isAlpha ? alpha : rgb;
      if (seen)
        error(DiagnosticId::RcTwice, token.span,
              std::string(word) + " { } stands in the stage a second time");
      seen = true;
      m_tokens.next();
      parsePortion(isAlpha ? stage.alpha : stage.rgb, isAlpha ? Usage::Alpha : Usage::Rgb);
      continue;
    }
    unknownWord("rgb, alpha or '}'", {"rgb", "alpha", "const0", "const1"});
    m_tokens.next();
    recover();
  }
}

/// Consumes the brace that ends a block, or reports the text's end in its place. Returns whether it
/// was one of the two. A block that is empty is an error.
bool CombinerParser::endsBlock(bool empty, const char *message, const char *hint) {
  if (m_tokens.accept(TokenKind::CloseBrace)) {
    if (empty)
      error(DiagnosticId::RcPortion, m_tokens.last(), message, hint);
    return true;
  }
  if (at(TokenKind::EndOfText))
    unexpected("'}'");
  return at(TokenKind::EndOfText);
}

/// Copies constants for every stage to each stage without its own.
void CombinerParser::finish(texture_shader::Values &values) {
  if (m_stages == 0) // a stage is always there
    m_state.stages[0] = {nothing(Usage::Rgb), nothing(Usage::Alpha)};
  m_state.count = std::uint8_t(std::clamp(m_stages, 1, combiners::kStages));
  const Span end = {std::uint32_t(m_text.size()), std::uint32_t(m_text.size())};
  if (!m_hasColor && !m_hasAlpha && !m_reporter.hasErrors())
    error(DiagnosticId::RcFinal, end, "the text writes neither out.rgb nor out.a",
          "end it with the final combiner: out.rgb = spare0; out.a = spare0.a;");
  if (m_readsProduct && !m_hasProduct)
    error(DiagnosticId::RcFinal, *m_readsProduct, "final_product is read, and nothing makes it",
          "write final_product = a * b; before it");
  m_state.perStageConstants = m_perStage;
  for (const Pair &own : m_own)
    m_state.perStageConstants |= own[0].has_value() || own[1].has_value();
  if (m_perStage && m_options.limits.perStageConstants == 0 &&
      m_options.limits.generalCombiners != 0)
    limit(DiagnosticId::LimitStageConstants, end,
          "per_stage_constants() needs NV_register_combiners2");
  for (int which = 0; which < 2; ++which) {
    const Constant &all = m_constants[std::size_t(which)];
    values[std::size_t(combiners::globalConstant(which))] = all;
    for (int stage = 0; stage < m_state.count && m_state.perStageConstants; ++stage) {
      const Constant &own = m_own[std::size_t(stage)][std::size_t(which)];
      values[std::size_t(combiners::stageConstant(stage, which))] = own ? own : all;
    }
  }
}

} // namespace arbiter::fp::nvparse
