#include <algorithm>
#include <tuple>

#include "apps/scene/panel/reader.h"
#include "apps/scene/picture.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/numerics.h"

namespace arbiter::scene {

namespace {

constexpr const char *kTwice = "panel_twice";

bool readSize(Reader &reader) {
  Panel &panel = reader.panel();
  return reader.integer("a width", 1, kMaxSide, panel.width) &&
         reader.integer("a height", 1, kMaxSide, panel.height);
}

bool readNumerics(Reader &reader) {
  Name &name = reader.panel().numerics;
  if (!reader.name("host, legacy, fp24 or fx9", name))
    return false;
  if (fp::numericsNamed(name.text))
    return true;
  const fp::Span span = name.span;
  name = {};
  return reader.warning(span, "panel_word", "these numerics are unknown and have no effect",
                        "one of host, legacy, fp24, fx9");
}

bool readProfile(Reader &reader) {
  Name &name = reader.panel().profile;
  if (!reader.file("a profile's name", name)) {
    name = {};
    return false;
  }
  if (fp::hw::isProfileFile(name.text) || fp::hw::findBuiltin(name.text) != nullptr)
    return true;
  std::string known = "one of";
  for (const std::string_view each : fp::hw::builtinNames())
    known.append(known == "one of" ? " " : ", ").append(each);
  const fp::Span span = name.span;
  name = {};
  return reader.warning(span, "panel_word", "this profile is unknown and has no effect",
                        known + ", or a TOML file");
}

bool readDepth(Reader &reader) {
  State &state = reader.panel().state;
  Chosen<Depth> depth;
  if (!reader.word("depth test", depth))
    return false;
  state.depth = depth;
  return !reader.acceptWord("write") || reader.onOff(state.depthWrite);
}

template <typename Enum>
bool readState(Reader &reader, const char *what, std::optional<Chosen<Enum>> &place) {
  Chosen<Enum> chosen;
  if (!reader.word(what, chosen))
    return false;
  place = chosen;
  return true;
}

bool readClear(Reader &reader) {
  for (Number &component : reader.panel().state.clear)
    if (!reader.number("red, green, blue and alpha", 0, 1, component))
      return false;
  return true;
}

bool readTarget(Reader &reader) {
  Target target;
  if (!reader.name("the target's name", target.name) ||
      !reader.integer("a width", 1, kMaxTextureSide, target.width) ||
      !reader.integer("a height", 1, kMaxTextureSide, target.height))
    return false;
  reader.panel().target = target;
  return true;
}

bool readThen(Reader &reader) {
  Name name;
  if (!reader.file("the file of a pass", name))
    return false;
  reader.panel().then.push_back(std::move(name));
  return true;
}

/// True if the setting may occur several times in a panel.
bool repeats(Setting setting) {
  return setting == Setting::Local || setting == Setting::Env || setting == Setting::Attrib ||
         setting == Setting::Texture || setting == Setting::Then || setting == Setting::Coordinate;
}

class Parser {
public:
  Parser(std::string_view text, Panel &panel) : m_text(text), m_panel(panel) {}

  void line(fp::Span span) {
    Reader reader(tokenise(m_text, span), m_panel);
    Behind behind = Behind::Other;
    while (!reader.at(TokenKind::End)) {
      clause(reader, behind);
      if (!reader.accept(TokenKind::Comma) && !reader.at(TokenKind::End))
        reader.skipClause();
    }
  }

private:
  /// The kind of the last clause. Filter words belong to a texture, and are ignored behind an
  /// invalid one.
  enum class Behind { Other, Texture, WrongTexture };

  void clause(Reader &reader, Behind &behind) {
    if (behind != Behind::Other && readSampler(reader, behind == Behind::Texture)) {
      end(reader);
      return;
    }
    behind = Behind::Other;
    if (!reader.at(TokenKind::Word)) {
      reader.expected("a word", Reader::wordList(wordsOf<Setting>()));
      reader.skipClause();
      return;
    }
    const auto setting = findWord<Setting>(reader.peek().text);
    if (!setting) {
      reader.unknownWord("word of a panel", wordsOf<Setting>());
      reader.skipClause();
      return;
    }
    const fp::Span span = reader.take().span;
    bool &seen = m_seen[std::size_t(*setting)];
    if (seen && !repeats(*setting))
      reader.error(span, kTwice, "'" + std::string(rowOf(*setting).word) + "' is said twice",
                   "one of the two is to go");
    seen = true;
    const bool good = readSetting(reader, *setting, span.begin);
    if (good)
      end(reader);
    if (*setting == Setting::Texture)
      behind = good ? Behind::Texture : Behind::WrongTexture;
    reader.skipClause();
  }

  static void end(Reader &reader) {
    if (!reader.atEnd())
      reader.leftOver();
    reader.skipClause();
  }

  std::string_view m_text;
  Panel &m_panel;
  std::array<bool, 64> m_seen = {};
};

} // namespace

bool readSetting(Reader &reader, Setting setting, std::uint32_t begin) {
  Panel &panel = reader.panel();
  switch (setting) {
  case Setting::Title:
    return reader.name("a title", panel.title);
  case Setting::Profile:
    return readProfile(reader);
  case Setting::Numerics:
    return readNumerics(reader);
  case Setting::Size:
    return readSize(reader);
  case Setting::Rate:
    return reader.number("frames a second", 1, 1000, panel.rate);
  case Setting::Mesh:
    return readMesh(reader);
  case Setting::Camera:
    return readCamera(reader);
  case Setting::Blend:
    return readState(reader, "kind of blending", panel.state.blend);
  case Setting::Depth:
    return readDepth(reader);
  case Setting::Cull:
    return readState(reader, "kind of face", panel.state.cull);
  case Setting::Stencil:
    return readState(reader, "use of the stencil buffer", panel.state.stencil);
  case Setting::Color:
    return reader.onOff(panel.state.colorWrite);
  case Setting::Clear:
    return readClear(reader);
  case Setting::Keep:
    panel.state.keep = true;
    return true;
  case Setting::Target:
    return readTarget(reader);
  case Setting::Coordinate:
    return readCoordinate(reader);
  case Setting::Local:
  case Setting::Env:
  case Setting::Attrib:
    return readParameter(reader, setting, begin);
  case Setting::Texture:
    return readTexture(reader, begin);
  case Setting::Vertex:
    return reader.file("the file of a vertex program", panel.vertex);
  case Setting::Then:
    return readThen(reader);
  }
  return false;
}

bool Panel::ok() const {
  return std::none_of(diagnostics.begin(), diagnostics.end(), [](const fp::Diagnostic &each) {
    return each.severity == fp::Severity::Error;
  });
}

Panel parsePanel(std::string_view text) {
  Panel panel;
  Parser parser(text, panel);
  for (const fp::Span line : panelLines(text)) {
    panel.written = true;
    parser.line(line);
  }
  return panel;
}

} // namespace arbiter::scene
