// Finds the document that a file belongs to, as its panel depends on the document.
#include <algorithm>
#include <filesystem>

#include "apps/scene/document.h"
#include "apps/scene/owner.h"

namespace arbiter::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCandidates = 256; ///< candidates in a folder
constexpr std::uintmax_t kMaxBytes = 1u << 20;

fs::path wholePath(const fs::path &path) {
  std::error_code error;
  return fs::absolute(path, error).lexically_normal();
}

/// Returns the programs in a folder, sorted, so that the same one is found each time.
std::vector<fs::path> programsIn(const fs::path &folder) {
  std::vector<fs::path> programs;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error);
       !error && entry != fs::directory_iterator() && programs.size() < kMaxCandidates;
       entry.increment(error)) {
    std::error_code none;
    if (entry->path().extension() == ".fp" && entry->is_regular_file(none) &&
        entry->file_size(none) <= kMaxBytes)
      programs.push_back(entry->path());
  }
  std::sort(programs.begin(), programs.end());
  return programs;
}

class Search {
public:
  Search(const std::string &path, const std::string &text)
      : m_path(wholePath(path)), m_text(text) {}

  std::optional<Panel> run() {
    // Files of a document lie beside it or in folders below it.
    for (const fs::path &folder : {m_path.parent_path(), m_path.parent_path().parent_path()})
      for (const fs::path &program : programsIn(folder))
        if (look(program))
          return std::move(m_found);
    return std::move(m_found);
  }

private:
  [[nodiscard]] Result<std::string, DocumentError> read(const std::string &path) const {
    return wholePath(path) == m_path ? Result<std::string, DocumentError>(m_text) : readText(path);
  }

  /// True if the file is a valid part of that document. If it has errors there, the panel is kept
  /// too.
  bool look(const fs::path &program) {
    if (wholePath(program) == m_path)
      return false;
    const auto text = readText(program.string());
    const Panel panel = parsePanel(text ? text.value() : std::string());
    if (panel.then.empty() && !panel.vertex.written())
      return false;
    const Document document = assemble(program.string(), text.value(),
                                       [this](const std::string &name) { return read(name); });
    for (std::size_t i = 1; i < document.files.size(); ++i)
      if (wholePath(document.files[i].name) == m_path) {
        const bool good = document.files[i].panel.ok();
        if (!m_found || good)
          m_found = document.files[i].panel;
        return good;
      }
    return false;
  }

  fs::path m_path;
  const std::string &m_text;
  std::optional<Panel> m_found;
};

} // namespace

std::optional<Panel> panelInItsDocument(const std::string &path, const std::string &text) {
  return Search(path, text).run();
}

} // namespace arbiter::scene
