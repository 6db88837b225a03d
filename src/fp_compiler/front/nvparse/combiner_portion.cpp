// Parses one portion of a general stage (NV_register_combiners 3.8.12.2).
#include <algorithm>

#include "fp_compiler/front/nvparse/combiner_parser.h"
#include "util/suggest.h"

namespace arbiter::fp::nvparse {

using combiners::Input;
using combiners::Mapping;
using combiners::Portion;
using combiners::Register;
using combiners::Scale;

namespace {

struct ScaleWord {
  std::string_view word;
  Scale scale;
  bool bias;
};
constexpr ScaleWord kScales[] = {
    {"scale_by_two", Scale::ByTwo, false},
    {"scale_by_four", Scale::ByFour, false},
    {"scale_by_one_half", Scale::ByOneHalf, false},
    {"bias_by_negative_one_half", Scale::None, true},
    {"bias_by_negative_one_half_scale_by_two", Scale::ByTwo, true},
};

const ScaleWord *scaleWord(std::string_view word) {
  const auto *const found = std::find_if(std::begin(kScales), std::end(kScales),
                                         [&](const ScaleWord &row) { return row.word == word; });
  return found == std::end(kScales) ? nullptr : found;
}

/// Returns the mapping whose value for zero is the given mapping's value for one.
Mapping ofOne(Mapping mapping) {
  switch (mapping) {
  case Mapping::UnsignedInvert:
    return Mapping::UnsignedIdentity;
  case Mapping::ExpandNegate:
  case Mapping::SignedNegate:
    return Mapping::ExpandNormal;
  case Mapping::HalfBiasNormal:
    return Mapping::HalfBiasNegate;
  case Mapping::HalfBiasNegate:
    return Mapping::HalfBiasNormal;
  default:
    return Mapping::UnsignedInvert;
  }
}

struct MappingWord {
  std::string_view word;
  Mapping plain;
  std::optional<Mapping> negated;
};
constexpr MappingWord kMappings[] = {
    {"unsigned", Mapping::UnsignedIdentity, {}},
    {"unsigned_invert", Mapping::UnsignedInvert, {}},
    {"expand", Mapping::ExpandNormal, Mapping::ExpandNegate},
    {"half_bias", Mapping::HalfBiasNormal, Mapping::HalfBiasNegate},
};

} // namespace

void CombinerParser::parsePortion(Portion &portion, Usage usage) {
  m_products = 0;
  m_hasSum = m_hasScale = false;
  const std::size_t errorsBefore = m_reporter.errorCount();
  if (!expect(TokenKind::OpenBrace, "'{'"))
    return recover();
  while (!m_reporter.full()) {
    if (endsBlock(m_products == 0 && m_reporter.errorCount() == errorsBefore,
                  "a block without a product", "leave the block out"))
      return;
    if (!parsePortionStatement(portion, usage))
      recover();
  }
}

bool CombinerParser::parsePortionStatement(Portion &portion, Usage usage) {
  if (!atStatement("a register to write, a scale or '}'"))
    return false;
  const Token first = m_tokens.peek();
  if (scaleWord(text(first))) {
    m_tokens.next();
    return parseScale(portion, first);
  }
  Register to = Register::Discard;
  Span span;
  if (!parseOutput(usage, to, span) || !expect(TokenKind::Equals, "'='"))
    return false;
  if (m_hasScale)
    error(DiagnosticId::RcPortion, span, "a result behind the scale",
          "the scale is of all results, and stands last");
  const bool mux = atWord("mux");
  if (mux || atWord("sum")) {
    const Token word = m_tokens.next();
    if (m_products != 2 || m_hasSum)
      error(DiagnosticId::RcPortion, word.span,
            std::string(text(word)) + "() behind " + std::to_string(m_products) +
                (m_hasSum          ? " products and a sum"
                 : m_products == 1 ? " product"
                                   : " products"),
            "it stands once, behind two products; discard = ... is one that is put nowhere");
    checkOutputs(portion, to, span);
    m_hasSum = true;
    portion.sum = to;
    portion.mux = mux;
    return parseEmpty() && endStatement();
  }
  return parseProduct(portion, usage, to, span);
}

bool CombinerParser::parseScale(Portion &portion, const Token &word) {
  const ScaleWord &row = *scaleWord(text(word));
  if (m_hasScale)
    error(DiagnosticId::RcTwice, word.span, "a second scale in this block");
  m_hasScale = true;
  portion.scale = row.scale;
  portion.bias = row.bias;
  return parseEmpty() && endStatement();
}

bool CombinerParser::parseOutput(Usage usage, Register &to, Span &span) {
  Named named;
  if (!parseRegister(named, Access::Write))
    return false;
  span = named.span;
  to = named.name;
  if (to == Register::Zero || to == Register::Constant0 || to == Register::Constant1 ||
      to == Register::Fog || to == Register::ETimesF || to == Register::Spare0PlusSecondary)
    error(DiagnosticId::RcRegister, named.span,
          std::string(text(named.word)) + " cannot be written in a stage",
          "col0, col1, spare0, spare1 and the textures' registers can, and discard");
  else if (named.usage && *named.usage != usage)
    error(DiagnosticId::RcComponent, named.span,
          usage == Usage::Rgb ? "rgb { } writes red, green and blue" : "alpha { } writes alpha",
          "leave the components out");
  return true;
}

void CombinerParser::checkOutputs(const Portion &portion, Register to, Span span) {
  if (to == Register::Discard)
    return;
  const bool again = (m_products > 0 && portion.ab == to) || (m_products > 1 && portion.cd == to) ||
                     (m_hasSum && portion.sum == to);
  if (again)
    error(DiagnosticId::RcOutputs, span, "this block writes " + wordOf(to) + " a second time",
          "the results of a block go to registers that differ, or to discard");
}

bool CombinerParser::parseProduct(Portion &portion, Usage usage, Register to, Span span) {
  const bool fits = m_products < 2 && !m_hasSum;
  if (!fits)
    error(DiagnosticId::RcPortion, span,
          m_hasSum ? "a product behind the sum" : "a third product in one block",
          "a block has two products, and their sum or mux");
  checkOutputs(portion, to, span);
  Input a, b;
  if (!parseMapped(usage, a))
    return false;
  b = {Register::Zero, Mapping::UnsignedInvert, usage};
  const Token sign = m_tokens.peek();
  const bool dot = sign.kind == TokenKind::Dot;
  if (dot || sign.kind == TokenKind::Times) {
    m_tokens.next();
    if (!parseMapped(usage, b))
      return false;
  }
  if (dot && usage == Usage::Alpha)
    error(DiagnosticId::RcDot, sign.span, "a dot product in alpha { }",
          "make it in rgb { }, and read its blue in alpha { } of the next stage");
  if (fits) {
    const std::size_t first = m_products == 0 ? 0 : 2;
    portion.inputs[first] = a;
    portion.inputs[first + 1] = b;
    (first == 0 ? portion.ab : portion.cd) = to;
    (first == 0 ? portion.abDot : portion.cdDot) = dot && usage == Usage::Rgb;
    ++m_products;
  }
  return endStatement("'*', '.' or ';'");
}

/// True at a dot that begins components: no space comes before it. After a space the dot is a dot
/// product.
bool CombinerParser::atComponents() const {
  if (!at(TokenKind::Dot) || m_tokens.peek().span.begin != m_tokens.lastEnd())
    return false;
  const std::string_view rest = m_text.substr(m_tokens.peek().span.end);
  std::size_t length = 0;
  while (length < rest.size() && length < 4 &&
         ((rest[length] >= 'a' && rest[length] <= 'z') ||
          (rest[length] >= 'A' && rest[length] <= 'Z') ||
          (rest[length] >= '0' && rest[length] <= '9') || rest[length] == '_'))
    ++length;
  const std::string_view word = rest.substr(0, length);
  return word == "rgb" || word == "a" || word == "b";
}

bool CombinerParser::parseRegister(Named &named, Access access) {
  constexpr const char *kWhat = "a register";
  if (!at(TokenKind::Identifier))
    return unexpected(kWhat);
  const std::optional<NamedRegister> known = registerOf(text(m_tokens.peek()));
  if (!known)
    return unexpected(kWhat, didYouMean(text(m_tokens.peek()), registerWords()));
  named.word = m_tokens.next();
  named.name = known->name;
  named.one = known->one;
  const bool isConstant = named.name == Register::Constant0 || named.name == Register::Constant1;
  note(named.word, access, isConstant ? SymbolKind::Parameter : SymbolKind::Temporary);
  if (const int unit = combiners::textureUnit(named.name);
      unit >= 0 && std::uint32_t(unit) >= m_options.limits.textureUnits &&
      m_options.limits.generalCombiners != 0)
    limit(DiagnosticId::ImageUnit, named.word.span,
          std::string(text(named.word)) + " has no texture unit of its number: there are " +
              std::to_string(m_options.limits.textureUnits));
  named.span = named.word.span;
  if (!atComponents())
    return true;
  m_tokens.next();
  const Token components = m_tokens.next();
  named.span.end = components.span.end;
  named.usage = text(components) == "rgb" ? Usage::Rgb
                : text(components) == "a" ? Usage::Alpha
                                          : Usage::Blue;
  if (named.name >= Register::TexturesEnd)
    error(DiagnosticId::RcComponent, components.span,
          std::string(text(named.word)) + " stands without components");
  return true;
}

bool CombinerParser::parseMapped(Usage usage, Input &input) {
  const bool minus = m_tokens.accept(TokenKind::Minus);
  const Token first = m_tokens.peek();
  const auto *const row = std::find_if(std::begin(kMappings), std::end(kMappings),
                                       [&](const MappingWord &r) { return atWord(r.word); });
  input.mapping = minus ? Mapping::SignedNegate : Mapping::SignedIdentity;
  Named named;
  if (row != std::end(kMappings)) {
    m_tokens.next();
    if (minus && !row->negated)
      error(DiagnosticId::RcMapping, first.span, std::string(row->word) + "() cannot be negated",
            "-x, -expand(x) and -half_bias(x) are the negated ones");
    input.mapping = minus ? row->negated.value_or(row->plain) : row->plain;
    if (!expect(TokenKind::OpenParen, "'('") || !parseRegister(named, Access::Read) ||
        !expect(TokenKind::CloseParen, "')'"))
      return false;
  } else if (!parseRegister(named, Access::Read)) {
    return false;
  }
  if (named.one)
    input.mapping = ofOne(input.mapping);
  input.source = named.name;
  input.usage = named.usage.value_or(usage);
  if (input.source == Register::Discard)
    error(DiagnosticId::RcRegister, named.span, "nothing reads discard");
  else if (input.source >= Register::TexturesEnd)
    error(DiagnosticId::RcRegister, named.span,
          std::string(text(named.word)) + " is the final combiner's alone");
  else if (input.usage == (usage == Usage::Rgb ? Usage::Blue : Usage::Rgb))
    error(DiagnosticId::RcComponent, named.span,
          usage == Usage::Rgb ? "rgb { } reads .rgb or .a" : "alpha { } reads .a or .b");
  else if (input.source == Register::Fog && input.usage == Usage::Alpha)
    error(DiagnosticId::RcRegister, named.span, "the alpha of fog is the final combiner's alone",
          usage == Usage::Alpha ? "fog.b is the blue of the fog colour" : "");
  return true;
}

} // namespace arbiter::fp::nvparse
