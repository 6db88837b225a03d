#include "apps/scene/panel/complete.h"

#include <algorithm>

#include "apps/scene/panel/token.h"
#include "apps/scene/words.h"
#include "fp_compiler/numerics.h"

namespace arbiter::scene {

namespace {

/// Knows the tokens of a clause before a place, and collects what may follow them.
class Place {
public:
  Place(std::vector<Token> before, bool behindTexture)
      : m_before(std::move(before)), m_behindTexture(behindTexture) {}

  std::vector<Candidate> run() {
    if (m_before.empty())
      begin();
    else if (const auto setting = findWord<Setting>(m_before.front().text))
      within(*setting);
    return std::move(m_found);
  }

private:
  void add(std::string_view word, std::string_view meaning = {}) {
    if (!word.empty())
      m_found.push_back({word, meaning});
  }
  template <typename Enum> void addAll() {
    for (const WordRow &row : wordsOf<Enum>())
      add(row.word, row.meaning);
  }

  [[nodiscard]] std::string_view last() const { return m_before.back().text; }
  [[nodiscard]] bool isFirst() const { return m_before.size() == 1; }
  [[nodiscard]] bool has(std::string_view word) const {
    return std::any_of(m_before.begin(), m_before.end(),
                       [&](const Token &token) { return token.text == word; });
  }

  void begin() {
    if (m_behindTexture) {
      addAll<Filter>();
      addAll<Wrap>();
      add("compare", "r is compared with the texture's depth");
    }
    addAll<Setting>();
  }

  /// Adds the arguments that the clause's last table word takes.
  template <typename Enum> void addArguments() {
    for (auto token = m_before.rbegin(); token != m_before.rend(); ++token)
      if (const auto word = findWord<Enum>(token->text)) {
        for (const ArgumentRow &row : rowOf(*word).arguments())
          add(row.word);
        return;
      }
  }

  /// Adds a table's words directly behind the setting.
  template <typename Enum> void one() {
    if (isFirst())
      addAll<Enum>();
    else
      addArguments<Enum>();
  }

  void onOff() {
    add("on");
    add("off");
  }

  void within(Setting setting) {
    switch (setting) {
    case Setting::Numerics:
      for (const std::string_view name : fp::kNumericsNames)
        add(name);
      break;
    case Setting::Mesh:
      mesh();
      break;
    case Setting::Camera:
      one<CameraKind>();
      break;
    case Setting::Blend:
      one<Blend>();
      break;
    case Setting::Depth:
      if (last() == "write")
        onOff();
      else if (isFirst())
        addAll<Depth>();
      else
        add("write", "whether depths are written");
      break;
    case Setting::Cull:
      one<Cull>();
      break;
    case Setting::Stencil:
      one<Stencil>();
      break;
    case Setting::Color:
      onOff();
      break;
    case Setting::Coordinate:
      if (m_before.back().kind == TokenKind::Equals)
        addAll<Coordinate>();
      break;
    case Setting::Texture:
      texture();
      break;
    case Setting::Local:
    case Setting::Env:
    case Setting::Attrib:
      parameter();
      break;
    default:
      break;
    }
  }

  void mesh() {
    if (isFirst() || last() == "and" || last() == "of") {
      addAll<Shape>();
      return;
    }
    addArguments<Shape>();
    add("at", "x y z: where its middle is");
    add("scale", "times this size");
    add("of", "the shape that this one is made of");
    add("and", "a further shape");
  }

  void texture() {
    if (m_before.back().kind == TokenKind::Equals || last() == "of") {
      addAll<Generator>();
      return;
    }
    addArguments<Generator>();
    add("of", "the image that this one is made of");
  }

  void parameter() {
    if (m_before.back().kind == TokenKind::Equals) {
      addAll<ValueKind>();
      return;
    }
    if (last() == "animate") {
      addAll<AnimationKind>();
      return;
    }
    if (std::none_of(m_before.begin(), m_before.end(),
                     [](const Token &token) { return token.kind == TokenKind::Equals; }))
      return;
    if (has("rotate"))
      addArguments<ValueKind>();
    add("in", "LOW..HIGH: its range");
    add("color", "to be picked as a colour");
    add("animate", "how it changes with time");
  }

  std::vector<Token> m_before;
  bool m_behindTexture;
  std::vector<Candidate> m_found;
};

} // namespace

std::optional<PanelPlace> completePanel(std::string_view text, std::uint32_t offset) {
  for (const fp::Span line : panelLines(text)) {
    if (offset < line.begin || offset > line.end)
      continue;
    PanelPlace place{{offset, offset}, {}};
    std::vector<Token> clause;
    bool texture = false;
    for (const Token &token : tokenise(text, line)) {
      if (token.kind == TokenKind::Word && token.span.begin < offset && offset <= token.span.end) {
        place.replaced = token.span;
        break;
      }
      if (token.span.begin >= offset || token.kind == TokenKind::End)
        break;
      if (token.kind != TokenKind::Comma) {
        clause.push_back(token);
        continue;
      }
      // Filter and wrap words may follow one another behind a texture.
      texture = !clause.empty() &&
                (clause[0].text == "texture" || (texture && !findWord<Setting>(clause[0].text)));
      clause.clear();
    }
    place.candidates = Place(std::move(clause), texture).run();
    return place;
  }
  return std::nullopt;
}

std::optional<PanelPlace> explainPanel(std::string_view text, std::uint32_t offset) {
  // The place behind the word's first byte belongs to the word.
  auto place = completePanel(text, offset + 1);
  if (!place || place->replaced.begin == place->replaced.end)
    return std::nullopt;
  const std::string_view word =
      text.substr(place->replaced.begin, place->replaced.end - place->replaced.begin);
  std::erase_if(place->candidates,
                [&](const Candidate &each) { return each.word != word || each.meaning.empty(); });
  return place->candidates.empty() ? std::nullopt : place;
}

} // namespace arbiter::scene
