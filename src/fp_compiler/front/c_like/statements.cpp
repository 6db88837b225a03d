#include "fp_compiler/front/c_like/statements.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <vector>

#include "fp_compiler/front/lexer.h"

namespace arbiter::fp::c_like {

namespace {

constexpr std::size_t kMaxTokens = 48; ///< of a statement that is read
constexpr std::size_t kLongestValue = 64;

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool has(const Vocabulary &vocabulary, std::string_view word) {
  return std::find(vocabulary.words.begin(), vocabulary.words.end(), word) !=
         vocabulary.words.end();
}

/// True for a type of GLSL, Cg, HLSL or C: "float", "vec4", "half4x4", "sampler2D".
bool isType(std::string_view word) {
  const std::string_view stem = word.substr(0, word.find_first_of("0123456789"));
  if (stem != word && isOneOf(stem, {"vec", "ivec", "bvec", "mat"}))
    return true;
  return isOneOf(stem, {"float", "double", "half", "fixed", "int", "bool"}) ||
         stem.starts_with("sampler");
}

bool isQualifier(std::string_view word) {
  return isOneOf(word, {"const", "static", "uniform", "in", "out", "inout", "varying", "attribute",
                        "lowp", "mediump", "highp", "flat", "smooth"});
}

/// Reads one statement, whatever its language.
class Reading {
public:
  Reading(std::string_view text, std::uint32_t begin, Dialect dialect)
      : m_text(text), m_dialect(dialect) {
    Lexer lexer(text, begin);
    while (m_tokens.size() < kMaxTokens) {
      m_tokens.push_back(lexer.next());
      const TokenKind kind = m_tokens.back().kind;
      if (kind == TokenKind::Semicolon || kind == TokenKind::EndOfText)
        break;
    }
    m_tokens.back() = {TokenKind::EndOfText, m_tokens.back().span};
  }

  [[nodiscard]] const Token &at(std::size_t i) const {
    return m_tokens[std::min(i, m_tokens.size() - 1)];
  }
  [[nodiscard]] bool is(std::size_t i, TokenKind kind) const { return at(i).kind == kind; }
  [[nodiscard]] bool isByte(std::size_t i, char byte) const {
    return !is(i, TokenKind::EndOfText) && m_text[at(i).span.begin] == byte;
  }
  [[nodiscard]] std::string_view word(std::size_t i) const {
    return is(i, TokenKind::Identifier) ? text(i, i + 1) : std::string_view();
  }
  /// Returns the text of the tokens [first, last).
  [[nodiscard]] std::string_view text(std::size_t first, std::size_t last) const {
    const std::uint32_t begin = at(first).span.begin;
    return m_text.substr(begin, at(last - 1).span.end - begin);
  }
  [[nodiscard]] bool ends(std::size_t i) const { return is(i, TokenKind::EndOfText); }

  std::optional<std::string> operand(std::size_t &i) const;
  std::optional<std::string> variable(std::size_t &i) const;

private:
  std::optional<std::string> madeVector(std::size_t &i) const;

  std::string_view m_text;
  Dialect m_dialect;
  std::vector<Token> m_tokens;
};

/// Reads a variable with its index and suffixes, in the assembly's words.
std::optional<std::string> Reading::variable(std::size_t &i) const {
  const std::string_view name = word(i);
  if (name.empty())
    return std::nullopt;
  std::string result = registerOf(name, m_dialect);
  const bool known = !result.empty();
  if (!known)
    result = name;
  ++i;
  if (is(i, TokenKind::OpenBracket) && is(i + 1, TokenKind::Integer) &&
      is(i + 2, TokenKind::CloseBracket)) {
    const std::string index(text(i, i + 3));
    const std::size_t place = result.find("[n]");
    if (place != std::string::npos)
      result.replace(place, 3, index);
    else if (!known)
      result += index;
    i += 3;
  }
  while (is(i, TokenKind::Dot) && !word(i + 1).empty()) {
    const std::string_view suffix = word(i + 1);
    const std::string components = fourComponents(suffix);
    result += "." + (components.empty() ? std::string(suffix) : components);
    i += 2;
  }
  return result;
}

/// Reads "vec4(1.0, 0.0, 0.0, 1.0)" as the constant "{1.0, 0.0, 0.0, 1.0}".
std::optional<std::string> Reading::madeVector(std::size_t &i) const {
  std::size_t at = i + 2;
  std::string values;
  std::size_t count = 0;
  for (; !ends(at) && !isByte(at, ')'); ++count) {
    const auto value = operand(at);
    if (!value || value->find_first_not_of("0123456789.eE+-") != std::string::npos)
      return std::nullopt;
    values += (count == 0 ? "" : ", ") + *value;
    if (is(at, TokenKind::Comma))
      ++at;
    else if (!isByte(at, ')'))
      return std::nullopt;
  }
  if (ends(at) || count == 0 || count > 4)
    return std::nullopt;
  i = at + 1;
  return count == 1 ? values : "{" + values + "}";
}

/// Reads one operand, in the assembly's words.
std::optional<std::string> Reading::operand(std::size_t &i) const {
  std::string sign;
  if (is(i, TokenKind::Minus) || is(i, TokenKind::Plus)) {
    sign = is(i, TokenKind::Minus) ? "-" : "";
    ++i;
  }
  std::optional<std::string> read;
  if (is(i, TokenKind::Integer) || is(i, TokenKind::Float)) {
    read = text(i, i + 1);
    ++i;
    if (isOneOf(word(i), {"f", "F", "h"}) && at(i).span.begin == at(i - 1).span.end)
      ++i;
  } else if (is(i, TokenKind::OpenBrace)) {
    const std::size_t begin = i;
    while (!ends(i) && !is(i, TokenKind::CloseBrace))
      ++i;
    if (!ends(i))
      read = text(begin, ++i);
  } else if (isType(word(i)) && isByte(i + 1, '(')) {
    read = madeVector(i);
  } else if (!isByte(i + 1, '(')) {
    read = variable(i);
  }
  return read ? std::optional(sign + *read) : std::nullopt;
}

bool isConstant(std::string_view value) {
  const std::size_t first = value.find_first_not_of("+-");
  return first != std::string_view::npos &&
         std::string_view("0123456789.{").find(value[first]) != std::string_view::npos;
}

/// Returns the instructions that give a variable the value of an operator.
std::string computed(char op, const std::string &to, const std::string &first,
                     const std::string &second, const Vocabulary &vocabulary) {
  switch (op) {
  case '*':
    return "MUL " + to + ", " + first + ", " + second + ";";
  case '/':
    return "RCP tmp.x, " + withComponent(second) + "; MUL " + to + ", " + first + ", tmp.x;";
  case '-':
    return (has(vocabulary, "SUB") ? "SUB " + to + ", " + first + ", "
                                   : "ADD " + to + ", " + first + ", -") +
           second + ";";
  case '+':
    return "ADD " + to + ", " + first + ", " + second + ";";
  default:
    return {};
  }
}

/// Returns the assembly's form of the value that an assignment gives.
std::string assigned(const Reading &reading, std::size_t i, const std::string &to,
                     const Vocabulary &vocabulary) {
  constexpr const char *kBegins = "a statement begins with its instruction: ";
  const std::string_view function = reading.word(i);
  if (!function.empty() && reading.isByte(i + 1, '(') && !isType(function)) {
    const std::string call = callHint(function, vocabulary);
    return call.empty() ? "" : "a statement begins with its instruction, and has no calls: " + call;
  }
  const auto first = reading.operand(i);
  if (first && reading.ends(i))
    return kBegins + ("MOV " + to + ", " + *first + ";");
  const char op = reading.ends(i)                   ? '\0'
                  : reading.isByte(i, '*')          ? '*'
                  : reading.isByte(i, '/')          ? '/'
                  : reading.is(i, TokenKind::Plus)  ? '+'
                  : reading.is(i, TokenKind::Minus) ? '-'
                                                    : '\0';
  ++i;
  const auto second = first && op != '\0' ? reading.operand(i) : std::nullopt;
  if (second && reading.ends(i))
    return kBegins + computed(op, to, *first, *second, vocabulary);
  return {};
}

std::string assignmentHint(const Reading &reading, const Vocabulary &vocabulary) {
  std::size_t i = 0;
  auto to = reading.variable(i);
  if (!to || to->size() > kLongestValue)
    return {};
  // A destination has a mask, which names each component once.
  const std::string_view suffix = i > 1 ? reading.word(i - 1) : std::string_view();
  if (const std::string four = fourComponents(suffix); !four.empty() && to->ends_with("." + four))
    to->resize(to->size() - four.size() + suffix.size());
  const std::size_t after = i;
  const bool changes = (reading.isByte(i, '*') || reading.isByte(i, '/') ||
                        reading.is(i, TokenKind::Plus) || reading.is(i, TokenKind::Minus)) &&
                       reading.is(i + 1, TokenKind::Equals);
  if (!changes && !reading.is(i, TokenKind::Equals))
    return {};
  i += changes ? 2 : 1;
  std::string hint;
  if (changes) {
    const auto second = reading.operand(i);
    const char op = reading.isByte(after, '*')           ? '*'
                    : reading.isByte(after, '/')         ? '/'
                    : reading.is(after, TokenKind::Plus) ? '+'
                                                         : '-';
    if (second && reading.ends(i))
      hint =
          "a statement begins with its instruction: " + computed(op, *to, *to, *second, vocabulary);
  } else {
    hint = assigned(reading, i, *to, vocabulary);
  }
  return !hint.empty() ? hint
                       : "a statement begins with its instruction, which does one step: ADD, MUL "
                         "or another, then " +
                             *to + " and its operands";
}

/// Returns the hint for a declaration: qualifiers, a type, a name, a value.
std::string declarationHint(const Reading &reading, Dialect dialect) {
  std::size_t i = 0;
  std::string_view qualifier;
  for (; isQualifier(reading.word(i)); ++i)
    if (isOneOf(reading.word(i), {"uniform", "in", "out", "inout", "varying", "attribute"}))
      qualifier = reading.word(i);
  const bool typed = isType(reading.word(i));
  const bool sampler = typed && reading.word(i).starts_with("sampler");
  i += typed ? 1 : 0;
  const std::string_view name = reading.word(i);
  if (i == 0 || name.empty() || name.size() > kLongestValue)
    return {};
  ++i;
  if (reading.isByte(i, '('))
    return formHint(Form::Function, dialect);
  const bool vertex = dialect == Dialect::Vertex || dialect == Dialect::OwnVertex;
  if (sampler)
    return formHint(Form::Sampler, dialect);
  if (isOneOf(qualifier, {"in", "attribute"}) || (qualifier == "varying" && !vertex))
    return formHint(Form::Input, dialect, name);
  if (isOneOf(qualifier, {"out", "inout", "varying"}))
    return formHint(Form::Output, dialect, name);
  if (reading.is(i, TokenKind::Equals)) {
    ++i;
    const auto value = reading.operand(i);
    if (value && reading.ends(i) && isConstant(*value) && value->size() <= kLongestValue)
      return formHint(Form::Value, dialect, name, *value);
  }
  return formHint(qualifier == "uniform" ? Form::Uniform : Form::Variable, dialect, name);
}

/// Returns the hint for a word of C that controls what runs.
std::string controlHint(const Reading &reading, Dialect dialect, const Vocabulary &vocabulary) {
  const std::string_view word = reading.word(0);
  if (word == "precision")
    return formHint(Form::Precision, dialect);
  if (word == "return")
    return formHint(Form::Return, dialect);
  const bool called = reading.isByte(1, '(');
  if (word == "void" || (word == "main" && called))
    return formHint(Form::Function, dialect);
  const bool condition = (word == "if" && called) || word == "else";
  const bool loop = isOneOf(word, {"for", "while"}) && called;
  if (!condition && !loop)
    return {};
  if (has(vocabulary, "BRA"))
    return "BRA branches, by a condition code: BRA label (GT.x);";
  if (has(vocabulary, "IF"))
    return condition ? "IF, ELSE and ENDIF do it, by a condition code: IF GT.x;"
                     : "REP and ENDREP, or LOOP and ENDLOOP, repeat what is between them";
  return formHint(condition ? Form::Condition : Form::Loop, dialect);
}

} // namespace

bool isCall(std::string_view text, Span word) {
  const std::size_t next = text.find_first_not_of(" \t", word.end);
  return next != std::string_view::npos && text[next] == '(';
}

std::string statementHint(std::string_view text, Span first, Dialect dialect,
                          const Vocabulary &vocabulary) {
  const Reading reading(text, first.begin, dialect);
  if (std::string hint = controlHint(reading, dialect, vocabulary); !hint.empty())
    return hint;
  if (std::string hint = declarationHint(reading, dialect); !hint.empty())
    return hint;
  // Register combiners assign.
  return dialect == Dialect::Combiners ? "" : assignmentHint(reading, vocabulary);
}

std::string hintFor(std::string_view text, Span first) {
  const std::string hint =
      nameHint(text.substr(first.begin, first.end - first.begin), Dialect::Combiners);
  return hint.empty() ? statementHint(text, first, Dialect::Combiners, {}) : hint;
}

std::string operandHint(std::string_view text, Span span, Dialect dialect,
                        const Vocabulary &vocabulary) {
  const std::string_view word = text.substr(span.begin, span.end - span.begin);
  if (std::string hint = nameHint(word, dialect); !hint.empty())
    return hint;
  if (!isCall(text, span))
    return {};
  if (isType(word)) {
    const Reading reading(text, span.begin, dialect);
    std::size_t i = 0;
    const auto made = reading.operand(i);
    if (made && !made->starts_with('{'))
      return "a number fills all four components: write " + *made;
    return "a constant vector stands in braces: " + made.value_or("{1.0, 0.0, 0.0, 1.0}");
  }
  const std::string call = callHint(word, vocabulary);
  return call.empty() ? "an operand is one value, and there are no calls"
                      : "an operand is one value, and there are no calls: " + call;
}

} // namespace arbiter::fp::c_like
