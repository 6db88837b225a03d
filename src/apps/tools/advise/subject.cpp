#include "apps/tools/advise/subject.h"

#include "fp_compiler/back/assembly/names.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::tools::advise {

namespace {

constexpr char kLetters[] = "xyzw";

std::vector<fp::Token> tokensOf(std::string_view text, fp::Span span) {
  std::vector<fp::Token> tokens;
  fp::Lexer lexer(text.substr(0, span.end), span.begin);
  for (fp::Token token = lexer.next(); token.kind != fp::TokenKind::EndOfText; token = lexer.next())
    tokens.push_back(token);
  return tokens;
}

bool isNumeral(const fp::Token &token) {
  return token.kind == fp::TokenKind::Integer || token.kind == fp::TokenKind::Float;
}

/// Joins tokens, with a blank after each comma.
std::string joined(std::string_view text, const std::vector<fp::Token> &tokens, std::size_t first,
                   std::size_t last) {
  std::string result;
  for (std::size_t i = first; i < last; ++i) {
    const fp::Span span = tokens[i].span;
    result += text.substr(span.begin, span.end - span.begin);
    if (tokens[i].kind == fp::TokenKind::Comma)
      result += ' ';
  }
  return result;
}

bool isWholeSuffix(std::string_view word) { return word == "xyzw" || word == "rgba"; }

/// Returns the suffix of an operand that reads as `like` at the positions of the mask. Other
/// positions repeat a neighbor's letter.
std::optional<std::string> letters(const Operand &like, std::uint8_t mask, bool scalar) {
  std::string word;
  bool identity = true, same = true;
  char previous = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    if (like.swizzle[i] > Select::W)
      return std::nullopt;
    const char letter = kLetters[int(like.swizzle[i])];
    identity = identity && letter == kLetters[i];
    same = same && (previous == 0 || previous == letter);
    previous = letter;
  }
  if (scalar || same)
    return std::string(1, previous);
  if (identity)
    return "";
  for (std::size_t i = 0; i < 4; ++i)
    word += mask >> i & 1 ? kLetters[int(like.swizzle[i])] : word.empty() ? '\0' : word.back();
  for (std::size_t i = 4; i-- > 0;)
    if (word[i] == 0)
      word[i] = word[i + 1];
  return word;
}

} // namespace

Subject::Subject(std::string_view text, const Setting &setting, fp::CheckResult check)
    : m_text(text), m_setting(setting), m_check(std::move(check)), m_flow(*m_check.program) {}

std::unique_ptr<Subject> Subject::read(std::string_view text, const Setting &setting) {
  if (setting.language == fp::ir::Language::AtiFragment || isNvparse(setting.language))
    return nullptr;
  fp::CheckResult check =
      fp::checkProgram(setting.language, text, {setting.limits, fp::LimitPolicy::Report});
  // Under NVIDIA's options one instruction of the text can become several of the code.
  if (!check.ok() || check.program->code.size() > kMaxInstructions ||
      check.program->options.nv != fp::ir::NvOption::None)
    return nullptr;
  return std::unique_ptr<Subject>(new Subject(text, setting, std::move(check)));
}

std::string Subject::tokens(fp::Span span) const {
  const std::vector<fp::Token> all = tokensOf(m_text, span);
  return joined(m_text, all, 0, all.size());
}

std::string Subject::base(std::uint32_t index, int operand) const {
  const Operand &source = at(index).src[std::size_t(operand)];
  const std::vector<fp::Token> all = tokensOf(m_text, source.span);
  std::size_t first = 0, last = all.size();
  while (first < last &&
         (all[first].kind == fp::TokenKind::Minus || all[first].kind == fp::TokenKind::Plus))
    ++first;
  if (last - first == 1 && isNumeral(all[first])) // a plain number cannot have a suffix
    return vectorText(program().parameters[source.index].constant);
  const bool suffixed =
      at(index).op != fp::ir::Opcode::Swz && last - first > 2 &&
      all[last - 2].kind == fp::TokenKind::Dot &&
      (source.swizzle != fp::ir::kIdentity ||
       isWholeSuffix(m_text.substr(all[last - 1].span.begin,
                                   all[last - 1].span.end - all[last - 1].span.begin)));
  return joined(m_text, all, first, suffixed ? last - 2 : last);
}

std::optional<std::string> Subject::spelled(const std::string &base, const Operand &like,
                                            std::uint8_t mask, bool scalar) {
  if (mask == 0)
    return std::nullopt;
  const std::uint8_t signs = like.negate & mask;
  if (signs != 0 && signs != mask)
    return std::nullopt;
  const std::optional<std::string> word = letters(like, mask, scalar);
  if (!word)
    return std::nullopt;
  return (signs != 0 ? "-" : "") + base + (word->empty() ? "" : "." + *word);
}

std::optional<std::string> Subject::spelled(std::uint32_t index, int operand, std::uint8_t mask,
                                            bool scalar) const {
  return spelled(base(index, operand), at(index).src[std::size_t(operand)], mask, scalar);
}

std::string Subject::destination(std::uint32_t index) const { return tokens(at(index).dst.span); }

std::string Subject::destinationBase(std::uint32_t index) const {
  std::string whole = destination(index);
  if (at(index).dst.mask == 0xF && !whole.ends_with(".xyzw") && !whole.ends_with(".rgba"))
    return whole;
  return whole.substr(0, whole.rfind('.'));
}

std::optional<float> Subject::number(std::uint32_t index, int operand, int position) const {
  return fp::opt::constantAt(program(), at(index).src[std::size_t(operand)], position,
                             fp::Numerics::Host);
}

std::optional<float> Subject::number(std::uint32_t index, int operand) const {
  const std::uint8_t mask = fp::ir::operandMask(at(index), operand);
  if (mask == 0)
    return std::nullopt;
  return fp::opt::uniformConstant(program(), at(index).src[std::size_t(operand)], mask,
                                  fp::Numerics::Host);
}

std::string Subject::fresh(const std::string &stem) const {
  std::string name = stem;
  for (int i = 2; m_text.find(name) != std::string_view::npos; ++i)
    name = stem + std::to_string(i);
  return name;
}

std::string maskText(std::uint8_t mask) {
  if (mask == 0xF)
    return "";
  std::string text = ".";
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1)
      text += kLetters[i];
  return text;
}

std::string numberText(float value) { return fp::assembly::numeral(value); }

std::string vectorText(const fp::ir::Vec4 &value) {
  std::string text = "{";
  for (const float component : value)
    text += (text.size() == 1 ? "" : ", ") + numberText(component);
  return text + "}";
}

std::string statementText(fp::ir::Opcode op, bool saturate, const std::string &destination,
                          const std::vector<std::string> &operands) {
  std::string text = std::string(fp::ir::info(op).mnemonic) + (saturate ? "_SAT " : " ");
  text += destination;
  for (const std::string &operand : operands)
    text += (text.ends_with(' ') ? "" : ", ") + operand;
  return text;
}

std::string textureText(unsigned unit, fp::ir::TexTarget target) {
  return "texture[" + std::to_string(unit) + "], " + fp::ir::targetText(target);
}

} // namespace arbiter::tools::advise
