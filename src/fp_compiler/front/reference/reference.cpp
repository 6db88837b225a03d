#include "fp_compiler/front/reference/reference.h"

#include <algorithm>

#include "fp_compiler/ati/shader.h"
#include "fp_compiler/front/words/language.h"

namespace arbiter::fp::reference {

namespace {

using ir::Language;

struct BindingRow {
  std::string_view path;
  Languages languages;
  std::string_view section;
  std::string_view components;
  std::string_view doc;
};

constexpr BindingRow kBindings[] = {
#define FP_BINDING(path, languages, section, components, doc)                                      \
  {path, Languages::languages, section, components, doc},
#include "fp_compiler/front/words/bindings.def"
#undef FP_BINDING
};

/// Expands the rest of a pattern. Appends each alternative to every element of `found`, from left
/// to right.
class Expander {
public:
  explicit Expander(std::string_view pattern) : m_rest(pattern), m_found(1) {}

  std::vector<std::vector<Segment>> run() {
    while (!m_rest.empty())
      step();
    return std::move(m_found);
  }

private:
  using Path = std::vector<Segment>;

  void step() {
    if (m_rest[0] == '.')
      m_rest.remove_prefix(1);
    if (m_rest[0] == '{' || m_rest[0] == '(') {
      const bool optional = m_rest[0] == '{';
      const std::size_t close = m_rest.find(optional ? '}' : ')');
      alternatives(m_rest.substr(1, close - 1), optional);
      m_rest.remove_prefix(close + 1);
    } else {
      const std::size_t end = std::min(m_rest.find_first_of(".[{("), m_rest.size());
      append({m_rest.substr(0, end)});
      m_rest.remove_prefix(end);
    }
    takeIndex();
  }

  void takeIndex() {
    if (!m_rest.starts_with("[n]"))
      return;
    m_rest.remove_prefix(3);
    const bool optional = m_rest.starts_with("?");
    m_rest.remove_prefix(optional ? 1 : 0);
    for (Path &path : m_found)
      path.back().index = optional ? Index::Optional : Index::Required;
  }

  void append(Segment segment) {
    for (Path &path : m_found)
      path.push_back(segment);
  }

  void alternatives(std::string_view words, bool optional) {
    std::vector<Path> grown;
    if (optional)
      grown = m_found;
    while (!words.empty()) {
      const std::size_t end = std::min(words.find('|'), words.size());
      std::string_view word = words.substr(0, end);
      word.remove_prefix(word[0] == '.' ? 1 : 0);
      for (Path path : m_found) {
        path.push_back({word});
        grown.push_back(std::move(path));
      }
      words.remove_prefix(std::min(end + 1, words.size()));
    }
    m_found = std::move(grown);
  }

  std::string_view m_rest;
  std::vector<Path> m_found;
};

std::vector<Binding> expand(Language language) {
  std::vector<Binding> all;
  for (const BindingRow &row : kBindings) {
    const bool ati = language == Language::AtiFragment;
    if (!isOf(row.languages, language == Language::ArbVertex) ||
        (ati && !row.path.starts_with("program.")))
      continue;
    for (std::vector<Segment> &segments : Expander(row.path).run())
      all.push_back({std::move(segments), row.section, row.components, row.doc});
  }
  return all;
}

bool startsWith(const Binding &binding, std::span<const std::string_view> path) {
  return binding.segments.size() >= path.size() &&
         std::equal(path.begin(), path.end(), binding.segments.begin(),
                    [](std::string_view word, const Segment &s) { return word == s.word; });
}

struct LanguageEntry {
  Languages languages;
  Entry entry;
};

constexpr LanguageEntry kKeywords[] = {
#define FP_KEYWORD(Enumerator, word, languages, section, doc)                                      \
  {Languages::languages, {word, section, doc}},
#include "fp_compiler/front/words/words.def"
};

constexpr LanguageEntry kOptions[] = {
#define FP_OPTION(word, language, apply, conflict, section, doc)                                   \
  {Language::language == Language::ArbVertex ? Languages::Vertex : Languages::Fragment,            \
   {word, section, doc}},
#include "fp_compiler/front/words/words.def"
};

std::vector<Entry> of(std::span<const LanguageEntry> rows, bool vertex) {
  std::vector<Entry> entries;
  for (const LanguageEntry &row : rows)
    if (isOf(row.languages, vertex))
      entries.push_back(row.entry);
  return entries;
}

/// Returns the rows of one of the two ARB languages. They are made once.
template <const auto &rows> std::span<const Entry> byLanguage(Language language) {
  static const std::vector<Entry> kFragment = of(rows, false);
  static const std::vector<Entry> kVertex = of(rows, true);
  if (language == Language::AtiFragment || isNvparse(language))
    return {};
  return language == Language::ArbVertex ? kVertex : kFragment;
}

constexpr Entry kTargets[] = {
#define FP_TARGET(word, Enumerator, shadow, doc) {word, "3.11.6", doc},
#include "fp_compiler/front/words/words.def"
};

constexpr std::string_view kFormulas[] = {
#define FP_FORMULA(Enumerator, text) text,
#include "fp_compiler/ir/formulas.def"
#undef FP_FORMULA
};
static_assert(std::size(kFormulas) == std::size_t(ir::kOpcodeRowCount), "every opcode has its row");

// formula() uses an opcode's number as its row.
enum class FormulaRow : std::uint8_t {
#define FP_FORMULA(Enumerator, text) Enumerator,
#include "fp_compiler/ir/formulas.def"
#undef FP_FORMULA
};
#define FP_OP(Enumerator, ...)                                                                     \
  static_assert(int(FormulaRow::Enumerator) == int(ir::Opcode::Enumerator));
#define FP_NV_OP(Enumerator, ...)                                                                  \
  static_assert(int(FormulaRow::Enumerator) == int(ir::Opcode::Enumerator));
#define FP_NV_WORD(Enumerator, ...)                                                                \
  static_assert(int(FormulaRow::Enumerator) == int(ir::Opcode::Enumerator));
#include "fp_compiler/ir/ops.def"

constexpr AtiOp kAtiOps[] = {
#define ATI_OP(Enumerator, word, formula) {word, ati::argumentCount(ati::Op::Enumerator), formula},
#include "fp_compiler/front/ati/words.def"
};
constexpr std::string_view kAti = "3.10.1";
constexpr Entry kAtiStatements[] = {
#define ATI_STATEMENT(word, doc) {word, kAti, doc},
#include "fp_compiler/front/ati/words.def"
};
constexpr Entry kAtiCoordinates[] = {
#define ATI_COORDINATES(Enumerator, word, doc) {word, kAti, doc},
#include "fp_compiler/front/ati/words.def"
};
constexpr Entry kAtiScales[] = {
#define ATI_SCALE(Enumerator, word, doc) {word, kAti, doc},
#include "fp_compiler/front/ati/words.def"
    {"sat", kAti, "clamps the result to [0, 1]"},
};
constexpr Entry kAtiModifiers[] = {
#define ATI_MODIFIER(word, doc) {word, kAti, doc},
#include "fp_compiler/front/ati/words.def"
};
constexpr AtiSource kAtiSources[] = {
#define ATI_SOURCE(word, count, doc) {word, count, doc},
#include "fp_compiler/front/ati/words.def"
};

constexpr Entry kCombinerWords[] = {
#define RC_FUNCTION(word, doc) {word, "", doc},
#include "fp_compiler/front/nvparse/words.def"
#define RC_WORD(word, doc) {word, "", doc},
#include "fp_compiler/front/nvparse/words.def"
};
constexpr Entry kShaderWords[] = {
#define TS_OPERATION(word, Enumerator, stage, stages, arguments, extension, doc) {word, "", doc},
#include "fp_compiler/front/nvparse/words.def"
#define TS_WORD(word, doc) {word, "", doc},
#include "fp_compiler/front/nvparse/words.def"
    {"expand", "", "a dot product of 2*x - 1"},
};
constexpr AtiSource kNvparseRegisters[] = {
#define RC_REGISTER(Enumerator, word, count, doc) {word, count, doc},
#include "fp_compiler/front/nvparse/words.def"
};

} // namespace

std::string Binding::path() const {
  std::string text;
  for (const Segment &segment : segments) {
    text += text.empty() ? "" : ".";
    text += segment.word;
    text += segment.index == Index::None ? "" : "[n]";
  }
  return text;
}

std::span<const Binding> bindings(Language language) {
  static const std::vector<Binding> kFragment = expand(Language::ArbFragment);
  static const std::vector<Binding> kVertex = expand(Language::ArbVertex);
  static const std::vector<Binding> kOfAti = expand(Language::AtiFragment);
  switch (language) {
  case Language::ArbFragment:
    return kFragment;
  case Language::ArbVertex:
    return kVertex;
  case Language::Combiners:
  case Language::TextureShaders:
    return {};
  case Language::AtiFragment:
    break;
  }
  return kOfAti;
}

std::vector<Segment> wordsBehind(Language language, std::span<const std::string_view> path) {
  std::vector<Segment> words;
  for (const Binding &binding : bindings(language)) {
    if (!startsWith(binding, path) || binding.segments.size() == path.size())
      continue;
    const Segment &next = binding.segments[path.size()];
    if (std::none_of(words.begin(), words.end(),
                     [&](const Segment &known) { return known.word == next.word; }))
      words.push_back(next);
  }
  return words;
}

const Binding *findBinding(Language language, std::span<const std::string_view> path) {
  for (const Binding &binding : bindings(language))
    if (binding.segments.size() == path.size() && startsWith(binding, path))
      return &binding;
  return nullptr;
}

std::span<const Entry> keywords(Language language) { return byLanguage<kKeywords>(language); }
std::span<const Entry> options(Language language) { return byLanguage<kOptions>(language); }
std::span<const Entry> targets() { return kTargets; }
std::string_view formula(ir::Opcode op) { return kFormulas[std::size_t(op)]; }
std::span<const AtiOp> atiOps() { return kAtiOps; }
std::span<const Entry> atiStatements() { return kAtiStatements; }
std::span<const Entry> atiCoordinates() { return kAtiCoordinates; }
std::span<const Entry> atiDestinationModifiers() {
  return std::span<const Entry>(kAtiScales).subspan(1); // the first row is no scale
}
std::span<const Entry> atiArgumentModifiers() { return kAtiModifiers; }
std::span<const AtiSource> atiSources() { return kAtiSources; }
std::span<const Entry> nvparseWords(Language language) {
  return language == Language::TextureShaders ? std::span<const Entry>(kShaderWords)
                                              : std::span<const Entry>(kCombinerWords);
}
std::span<const AtiSource> nvparseRegisters() { return kNvparseRegisters; }

} // namespace arbiter::fp::reference
