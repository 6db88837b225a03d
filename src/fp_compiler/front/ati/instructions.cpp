#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/ati/words.h"
#include "fp_compiler/front/words/parts.h"
#include "util/suggest.h"

namespace arbiter::fp::ati {

namespace {
constexpr std::uint8_t kColor = 7;
} // namespace

bool Parser::parseInstruction(const Token &first, Op op) {
  // A wrong instruction counts too: the pass was meant to have one.
  m_hasInstructions = true;
  Statement statement;
  statement.operation.op = op;
  if (!parseDestination(statement) || !parseArguments(statement))
    return false;
  statement.span = {first.span.begin, m_tokens.lastEnd()};
  checkPairing(statement);
  addToPairs(statement);
  return endStatement();
}

bool Parser::parseDestination(Statement &statement) {
  Token name;
  if (!parseRegister("a register, r0 to r5", name, statement.operation.destination))
    return false;
  statement.maskSpan = name.span;
  enum Stage { kMask, kScale, kSaturate, kDone } stage = kMask;
  while (m_tokens.accept(TokenKind::Dot)) {
    Token word;
    if (!expectWord("a mask, a scale or sat", word))
      return false;
    const std::uint8_t mask = maskOf(text(word));
    const std::optional<Scale> scale = scaleOf(text(word));
    const bool saturate = text(word) == "sat";
    if (!mask && !scale && !saturate) {
      const bool letters = text(word).find_first_not_of("rgba") == std::string_view::npos;
      error(DiagnosticId::AtiDestinationSuffix, word.span,
            "no destination mask or modifier " + quote(text(word)),
            letters ? "the letters of a mask are one or more of rgba, in that order"
                    : didYouMean(text(word), {"2x", "4x", "8x", "half", "quarter", "eighth", "sat"},
                                 "a mask, then one of 2x 4x 8x half quarter eighth, then sat"));
      continue;
    }
    const Stage own = mask ? kMask : scale ? kScale : kSaturate;
    if (own < stage)
      error(DiagnosticId::AtiDestinationSuffix, word.span,
            "'." + std::string(text(word)) + "' a second time or out of order",
            "a mask, then one of 2x 4x 8x half quarter eighth, then sat");
    stage = Stage(own + 1);
    if (mask) {
      statement.mask = mask;
      statement.maskSpan = word.span;
    } else if (scale) {
      statement.operation.scale = *scale;
    } else {
      statement.operation.saturate = true;
    }
  }
  return true;
}

bool Parser::parseArguments(Statement &statement) {
  const int count = argumentCount(statement.operation.op);
  for (int i = 0; i < count; ++i) {
    // The printed grammar lacks the first comma, but the examples have it.
    if (i == 0)
      m_tokens.accept(TokenKind::Comma);
    if (m_tokens.at(TokenKind::Semicolon))
      return missingArgument(statement.operation.op, i);
    if (i > 0 && !expect(TokenKind::Comma, "','",
                         std::string(name(statement.operation.op)) + " takes " +
                             std::to_string(count) + " arguments"))
      return false;
    if (!parseArgument(statement, i, statement.operation.arguments[std::size_t(i)]))
      return false;
  }
  if (m_tokens.at(TokenKind::Comma))
    return unexpected("';'", std::string(name(statement.operation.op)) + " takes " +
                                 std::to_string(count) + (count == 1 ? " argument" : " arguments"));
  return true;
}

bool Parser::missingArgument(Op op, int at) {
  const int count = argumentCount(op);
  const std::string which = count == 1 ? "argument" : std::string(ordinal(at)) + " argument";
  error(DiagnosticId::Syntax, m_tokens.peek().span,
        "the " + which + " of " + std::string(name(op)) + " is missing",
        std::string(name(op)) + " takes a register and " + std::to_string(count) +
            (count == 1 ? " argument" : " arguments"));
  return false;
}

bool Parser::parseArgument(const Statement &statement, int at, Argument &argument) {
  Token token;
  if (!parseSource(argument, token) || !parseArgumentSuffixes(argument))
    return false;
  checkSource(statement, at, argument, token.span);
  return true;
}

bool Parser::parseSource(Argument &argument, Token &token) {
  constexpr const char *kWhat = "an argument: r0 to r5, c0 to c7, 0, 1, color0 or color1";
  if (!m_tokens.at(TokenKind::Identifier))
    return unexpected(kWhat);
  token = m_tokens.peek();
  const std::string_view word = text(token);
  const std::optional<std::uint8_t> constant = numbered(word, 'c');
  if (isRegister(token, Access::Read, argument.index)) {
    argument.source = Source::Register;
  } else if (constant && *constant < kConstants) {
    note(token, Access::Read);
    argument.source = Source::Constant;
    argument.index = *constant;
  } else if (word == "0" || word == "1") {
    argument.source = word == "0" ? Source::Zero : Source::One;
  } else if (word == "color0" || word == "color1") {
    argument.source = word == "color0" ? Source::Primary : Source::Secondary;
  } else {
    std::string hint;
    if (numbered(word, 't'))
      hint = "PassTexCoord brings texture coordinates into a register";
    else if (constant)
      hint = "the constants are c0 to c7";
    else if (word.find_first_not_of("0123456789") == std::string_view::npos)
      hint = "bind other numbers to a constant in a block of constants";
    return unexpected(kWhat, std::move(hint));
  }
  m_tokens.next();
  return true;
}

bool Parser::parseArgumentSuffixes(Argument &argument) {
  constexpr std::string_view kModifiers[] = {"neg", "2x", "bias", "comp"};
  bool *const flags[] = {&argument.negate, &argument.twice, &argument.bias, &argument.complement};
  constexpr const char *kOrder = "one of r g b a, then any of neg, 2x, bias, comp in that order";
  std::size_t stage = 0; // 0 replication, then one more than the modifier's place
  while (m_tokens.accept(TokenKind::Dot)) {
    Token word;
    if (!expectWord("a component, neg, 2x, bias or comp", word))
      return false;
    std::size_t own = 0;
    const std::uint8_t mask = maskOf(text(word));
    const bool replicate = mask != 0 && (mask & (mask - 1)) == 0;
    if (!replicate)
      for (std::size_t i = 0; i < std::size(kModifiers); ++i)
        if (text(word) == kModifiers[i])
          own = i + 1;
    if (!replicate && own == 0) {
      error(DiagnosticId::AtiArgumentSuffix, word.span, "no argument modifier " + quote(text(word)),
            mask ? "an argument takes all four components, or one of r g b a for all"
                 : didYouMean(text(word), kModifiers, kOrder));
      continue;
    }
    if (own < stage)
      error(DiagnosticId::AtiArgumentSuffix, word.span,
            "'." + std::string(text(word)) + "' a second time or out of order", kOrder);
    stage = own + 1;
    if (replicate)
      argument.replicate = Replicate(1 + std::string_view("rgba").find(text(word)));
    else
      *flags[own - 1] = true;
  }
  return true;
}

void Parser::checkSource(const Statement &statement, int at, const Argument &argument, Span span) {
  const Operation &operation = statement.operation;
  if (argument.source == Source::Constant) {
    if (!m_declared[argument.index])
      error(DiagnosticId::AtiConstantUndeclared, span,
            "c" + std::to_string(argument.index) + " is not declared",
            "bind it between StartConstants; and EndConstants;");
    const Argument &a = operation.arguments[0];
    const Argument &b = operation.arguments[1];
    if (at == 2 && a.source == Source::Constant && b.source == Source::Constant &&
        a.index != b.index && argument.index != a.index && argument.index != b.index)
      error(DiagnosticId::AtiConstantCount, span, "a third constant in one instruction",
            "an instruction reads at most two different constants; MOV one to a register");
    return;
  }
  if (argument.source != Source::Primary && argument.source != Source::Secondary)
    return;
  m_colorsUsed[argument.source == Source::Secondary] = true;
  if (m_prelim)
    error(DiagnosticId::AtiColorInPrelimPass, span,
          "color" + std::to_string(int(argument.source == Source::Secondary)) +
              " in the preliminary pass",
          "the colours can be read in the output pass only");
  const bool alpha =
      argument.replicate == Replicate::Alpha ||
      (argument.replicate == Replicate::None &&
       (operation.op == Op::Dot4 || (!isDot(operation.op) && (statement.mask & kAlpha) != 0)));
  if (argument.source == Source::Secondary && alpha)
    error(DiagnosticId::AtiSecondaryAlpha, span, "the alpha of color1, which has none",
          argument.replicate == Replicate::Alpha || operation.op == Op::Dot4
              ? "use .r, .g or .b of it"
              : "write the colour alone, as in r0.rgb, or use .r, .g or .b of color1");
}

void Parser::checkPairing(const Statement &statement) {
  if (statement.mask != kAlpha)
    return;
  if (isDot(statement.operation.op))
    error(DiagnosticId::AtiDotAlpha, statement.maskSpan,
          std::string(name(statement.operation.op)) + " into alpha alone",
          "give the mask a colour component: .ra, .rgba or none");
  else if (m_openDot4)
    error(DiagnosticId::AtiAfterDot4, statement.maskSpan,
          "alpha alone after a DOT4 that does not write alpha",
          "let the DOT4 write alpha, or put an instruction that writes a colour between");
}

void Parser::addToPairs(const Statement &statement) {
  const bool color = statement.mask & kColor;
  const bool alpha = statement.mask & kAlpha;
  const bool completes = !color && m_openPair;
  if (!completes && ++m_pairs > kMaxPairs) {
    if (m_pairs == kMaxPairs + 1)
      error(DiagnosticId::AtiPairs, statement.span, "a ninth instruction pair in one pass",
            "a pass has 8 pairs of one colour and one alpha instruction; pair up instructions "
            "that write .rgb and .a, or use both passes");
  } else if (m_pairs <= kMaxPairs) {
    Pair &pair = m_pass->pairs[std::size_t(m_pairs) - 1];
    m_pass->pairCount = std::uint8_t(m_pairs);
    if (!completes)
      pair.span = statement.span;
    if (color) {
      pair.color = statement.operation;
      pair.color->mask = statement.mask & kColor;
    }
    if (alpha)
      pair.alpha = statement.operation;
  }
  m_openPair = color && !alpha;
  m_openDot4 = m_openPair && statement.operation.op == Op::Dot4;
}

} // namespace arbiter::fp::ati
