#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "apps/scene/document.h"
#include "apps/scene/owner.h"

namespace arbiter::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = 64u << 20;

/// Returns a folder's main program; empty if it has none, or several and no main one.
std::string mainOf(const fs::path &folder) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  const fs::path own = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  for (const fs::path &name : {own, fs::path("main")})
    if (fs::is_regular_file(folder / (name.string() + ".fp"), error))
      return (folder / (name.string() + ".fp")).string();
  std::string only;
  int count = 0;
  for (auto entry = fs::directory_iterator(folder, error);
       !error && entry != fs::directory_iterator(); entry.increment(error))
    if (entry->path().extension() == ".fp") {
      only = entry->path().string();
      ++count;
    }
  return count == 1 ? only : std::string();
}

bool lacksTarget(const Panel &panel) {
  return std::any_of(panel.diagnostics.begin(), panel.diagnostics.end(),
                     [](const auto &each) { return std::string_view(each.id) == "panel_target"; });
}

/// Reports images and meshes that do not exist. Their content is read when they are drawn.
class FileSearch {
public:
  FileSearch(const std::string &path, Panel &panel)
      : m_folder(fs::path(path).parent_path()), m_panel(panel) {}

  void run() {
    for (const TextureSpec &texture : m_panel.textures)
      look(texture.source);
    for (const ShapeSpec &shape : m_panel.mesh)
      look(shape);
  }

private:
  void look(const TextureSource &source) {
    for (const Name &file : source.files)
      look(file);
    for (const TextureSource &inner : source.of)
      look(inner);
  }
  void look(const ShapeSpec &shape) {
    look(shape.file);
    for (const ShapeSpec &inner : shape.of)
      look(inner);
  }
  void look(const Name &file) {
    std::error_code error;
    if (!file.written() || fs::is_regular_file(m_folder / file.text, error) ||
        m_panel.diagnostics.size() >= kMaxPanelDiagnostics)
      return;
    m_panel.diagnostics.push_back(
        {fp::Severity::Error, "panel_file", file.span,
         (m_folder / file.text).string() + ": " + (error ? error.message() : "is no regular file"),
         "files of a document lie beside it"});
  }

  const fs::path m_folder;
  Panel &m_panel;
};

} // namespace

Result<std::string, DocumentError> readText(const std::string &path) {
  std::error_code error;
  // A pipe could block the reader forever.
  if (!fs::is_regular_file(path, error))
    return DocumentError{path + ": " + (error ? error.message() : "is no regular file")};
  if (fs::file_size(path, error) > kMaxBytes)
    return DocumentError{path + ": larger than 64 MiB"};
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.is_open() || file.bad())
    return DocumentError{path + ": " + std::strerror(errno)};
  return bytes;
}

Result<Document, DocumentError> loadDocument(const std::string &path) {
  std::error_code error;
  std::string name = path;
  if (fs::is_directory(path, error)) {
    name = mainOf(path);
    if (name.empty())
      return DocumentError{path + ": no document: neither a program of the folder's name, nor "
                                  "main.fp, nor one program with the ending .fp"};
  }
  auto text = readText(name);
  if (!text)
    return text.error();
  return assemble(name, std::move(text).value(), readText);
}

std::vector<fp::Diagnostic> checkPanel(const std::string &path, const std::string &text) {
  Panel panel = parsePanel(text);
  std::vector<fp::Diagnostic> others; // of other programs in the text
  if (panel.written && !path.empty()) {
    const Document document = assemble(path, text, readText);
    panel = document.panel();
    for (std::size_t i = 1; i < document.files.size(); ++i)
      if (document.files[i].name == document.files[0].name)
        others = document.files[i].panel.diagnostics;
    // A later pass refers to targets that only its document has.
    if (lacksTarget(panel))
      if (auto inDocument = panelInItsDocument(path, text))
        panel = std::move(*inDocument);
    FileSearch(path, panel).run();
  }
  panel.diagnostics.insert(panel.diagnostics.end(), others.begin(), others.end());
  std::stable_sort(panel.diagnostics.begin(), panel.diagnostics.end(),
                   [](const auto &a, const auto &b) { return a.span.begin < b.span.begin; });
  return std::move(panel.diagnostics);
}

} // namespace arbiter::scene
