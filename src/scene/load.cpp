#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scene/document.h"

namespace arbiter::scene {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxBytes = 64u << 20;

/// The program that a folder is opened by; empty if there is none, or no telling which.
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

} // namespace

Result<std::string, DocumentError> readText(const std::string &path) {
  std::error_code error;
  // A pipe could keep the reader waiting for ever.
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
  if (panel.written && !path.empty())
    panel = assemble(path, text, readText).panel();
  std::stable_sort(panel.diagnostics.begin(), panel.diagnostics.end(),
                   [](const auto &a, const auto &b) { return a.span.begin < b.span.begin; });
  return std::move(panel.diagnostics);
}

} // namespace arbiter::scene
