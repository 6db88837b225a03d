// Assembles a document with all of its files from one text.
#include <algorithm>

#include "apps/scene/document.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::scene {

namespace {

using fp::ir::Language;

constexpr std::size_t kMaxPasses = 16;

void complain(ProgramFile &file, fp::Span span, const char *id, std::string message,
              std::string hint = {}) {
  if (file.panel.diagnostics.size() < kMaxPanelDiagnostics)
    file.panel.diagnostics.push_back(
        {fp::Severity::Error, id, span, std::move(message), std::move(hint)});
}

std::string folderOf(const std::string &path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

/// Blanks a part of the text and keeps its line breaks.
void makeBlank(fp::Span span, std::string &text) {
  const auto begin = text.begin();
  std::replace_if(
      begin + span.begin, begin + span.end, [](char c) { return c != '\n' && c != '\r'; }, ' ');
}

class Assembler {
public:
  Assembler(Document &document, const ReadText &read) : m_document(document), m_read(read) {}

  void run() {
    readProfile();
    addPass(0);
    // This is a copy, as adding files reallocates them.
    const std::vector<Name> further = m_document.panel().then;
    for (const Name &name : further) {
      if (m_document.passes.size() == kMaxPasses) {
        complain(m_document.files[0], name.span, "panel_range", "a document has at most 16 passes");
        return;
      }
      if (const int file = add(0, name); file >= 0)
        addPass(file);
    }
  }

private:
  /// Reads the profile's name. Its line has been checked already.
  void readProfile() {
    ProgramFile &main = m_document.files[0];
    Name &name = main.panel.profile;
    if (!fp::hw::isProfileFile(name.text))
      return;
    const std::string path = m_document.profile();
    const auto text = m_read(path);
    std::string fault;
    if (!text)
      fault = text.error().message;
    else if (const auto profile = fp::hw::parseProfile(text.value(), path); !profile)
      fault = profile.error().message;
    if (fault.empty())
      return;
    complain(main, name.span, "panel_file", std::move(fault),
             "arbiter profiles NAME prints a profile to begin from");
    name = {};
  }

  /// Returns the number of the file that a line of another file names; -1 after a diagnostic.
  int add(int from, const Name &name) {
    const std::string path = m_document.folder + name.text;
    for (std::size_t i = 0; i < m_document.files.size(); ++i)
      if (m_document.files[i].name == path)
        return int(i);
    auto text = m_read(path);
    if (!text) {
      complain(m_document.files[std::size_t(from)], name.span, "panel_file", text.error().message,
               "files of a document lie beside it");
      return -1;
    }
    m_document.files.push_back(programFile(path, std::move(text).value()));
    return int(m_document.files.size()) - 1;
  }

  void addPass(int index) {
    Pass pass;
    pass.panel = index;
    const Name vertex = m_document.files[std::size_t(index)].panel.vertex;
    if (m_document.files[std::size_t(index)].language == Language::ArbVertex) {
      pass.vertex = index;
    } else {
      pass.fragment = index;
      pass.vertex = vertex.written() ? addVertex(index, vertex) : addSibling(index);
    }
    m_document.passes.push_back(pass);
  }

  /// Returns the vertex program in the same text; -1 if it has none.
  int addSibling(int of) {
    const ProgramFile &file = m_document.files[std::size_t(of)];
    const auto programs = fp::programsOf(file.text);
    if (std::none_of(programs.begin(), programs.end(),
                     [](const auto &each) { return each.language == Language::ArbVertex; }))
      return -1;
    m_document.files.push_back(programFile(file.name, file.text, Language::ArbVertex));
    return int(m_document.files.size()) - 1;
  }

  int addVertex(int from, const Name &name) {
    int file = add(from, name);
    if (file >= 0 && m_document.files[std::size_t(file)].language != Language::ArbVertex)
      if (const int sibling = addSibling(file); sibling >= 0)
        file = sibling;
    if (file < 0 || m_document.files[std::size_t(file)].language == Language::ArbVertex)
      return file;
    complain(m_document.files[std::size_t(from)], name.span, "panel_file",
             name.text + " is no vertex program", "its text begins with !!ARBvp1.0");
    return -1;
  }

  Document &m_document;
  const ReadText &m_read;
};

/// Checks lines of one file that refer to targets in other files.
class TargetCheck {
public:
  explicit TargetCheck(Document &document) : m_document(document) {}

  void run() {
    for (ProgramFile &file : m_document.files)
      check(file);
  }

private:
  [[nodiscard]] const Target *find(const std::string &name) const {
    for (const Pass &pass : m_document.passes)
      if (const auto &target = m_document.panelOf(pass).target; target && target->name.text == name)
        return &*target;
    return nullptr;
  }

  [[nodiscard]] std::string known() const {
    std::string names;
    for (const Pass &pass : m_document.passes)
      if (const auto &target = m_document.panelOf(pass).target)
        names += (names.empty() ? "there is " : ", ") + target->name.text;
    return names.empty() ? "a pass has one by a line '#@ target NAME WIDTH HEIGHT'" : names;
  }

  void check(ProgramFile &file) {
    for (const TextureSpec &texture : file.panel.textures) {
      const Name &name = texture.source.target;
      if (!name.written())
        continue;
      exists(file, name);
      if (file.panel.target && file.panel.target->name.text == name.text)
        complain(file, name.span, "panel_target", "the pass reads the target that it draws to",
                 "'feedback' reads the last frame's picture");
    }
    for (const Parameter &parameter : file.panel.parameters)
      if (parameter.kind.value == ValueKind::Camera)
        exists(file, parameter.target);
    if (file.panel.target && file.panel.state.stencil &&
        file.panel.state.stencil->value != Stencil::Off)
      complain(file, file.panel.state.stencil->span, "panel_target",
               "a target has no stencil buffer", "only passes that draw the picture can use one");
    if (const auto &own = file.panel.target)
      if (const Target *other = find(own->name.text);
          other != nullptr &&
          (other->width.value != own->width.value || other->height.value != own->height.value))
        complain(file, own->name.span, "panel_target", "this target has another size elsewhere");
  }

  void exists(ProgramFile &file, const Name &name) {
    if (find(name.text) == nullptr)
      complain(file, name.span, "panel_target", "no pass draws into a target '" + name.text + "'",
               known());
  }

  Document &m_document;
};

} // namespace

ProgramFile programFile(std::string name, std::string text, std::optional<Language> language) {
  const std::vector<fp::FileProgram> programs = fp::programsOf(text);
  const auto firstOf = [&](Language wanted) -> const fp::FileProgram * {
    for (const fp::FileProgram &each : programs)
      if (each.language == wanted)
        return &each;
    return nullptr;
  };
  const fp::FileProgram *main = firstOf(Language::ArbFragment);
  if (main == nullptr)
    main = &programs.front();
  const fp::FileProgram *meant = language ? firstOf(*language) : main;
  if (meant == nullptr)
    meant = main;
  std::string lines = text;
  if (meant != main) {
    makeBlank({0, meant->span.begin}, lines);
    makeBlank({meant->span.end, std::uint32_t(lines.size())}, lines);
  }
  for (const fp::FileProgram &each : programs)
    if (&each != meant)
      makeBlank(each.span, lines);
  return {std::move(name), std::move(text), meant->language, parsePanel(lines), meant->span};
}

Document assemble(const std::string &path, std::string text, const ReadText &read) {
  Document document;
  document.folder = folderOf(path);
  document.files.push_back(programFile(path, std::move(text)));
  Assembler(document, read).run();
  TargetCheck(document).run();
  return document;
}

} // namespace arbiter::scene
