#include "tools/check/find_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>

#include "fp_compiler/compiler.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtensions[] = {".fp",    ".vp",   ".atifs", ".arbfp",
                                            ".arbvp", ".nvrc", ".nvts"};

bool beginsAsProgram(const fs::path &path) {
  std::array<char, 8> head = {};
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head.size());
  return fp::languageOfText({head.data(), std::size_t(file.gcount())}).has_value();
}

bool isProgram(const fs::directory_entry &entry) {
  std::error_code error;
  const std::string extension = entry.path().extension().string();
  const bool named =
      std::find(std::begin(kExtensions), std::end(kExtensions), extension) != std::end(kExtensions);
  // A link that leads nowhere is by its name a program that cannot be read, and is reported so.
  if (!entry.is_regular_file(error))
    return named && entry.is_symlink(error) && !entry.exists(error);
  return named || beginsAsProgram(entry.path());
}

bool isFolder(const fs::directory_entry &entry) {
  std::error_code error;
  return entry.is_directory(error) && !entry.is_symlink(error);
}

/// Adds the programs below a folder, unordered.
void search(const fs::path &folder, FoundFiles &found) {
  std::error_code error;
  fs::directory_iterator at(folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    if (at->path().filename().native().starts_with('.'))
      continue;
    if (isFolder(*at))
      search(at->path(), found);
    else if (isProgram(*at))
      found.paths.push_back(at->path().native());
  }
  if (error)
    found.faults.push_back(folder.native() + ": " + error.message());
}

/// Leaves out, with a fault each, the paths that name a file a second time: by another operand, or
/// by a folder that holds it. What is read twice would be counted twice, and standard input is
/// empty the second time.
void leaveOutRepeated(FoundFiles &found) {
  std::set<fs::path> seen;
  std::vector<std::string> once;
  for (std::string &path : found.paths) {
    std::error_code error;
    if (seen.insert(path == "-" ? fs::path(path) : fs::absolute(path, error).lexically_normal())
            .second)
      once.push_back(std::move(path));
    else
      found.faults.push_back(path + ": given twice");
  }
  found.paths = std::move(once);
}

} // namespace

FoundFiles findFiles(std::span<const std::string> operands) {
  FoundFiles found;
  for (const std::string &operand : operands) {
    std::error_code error;
    if (operand == "-" || !fs::is_directory(operand, error)) {
      found.paths.push_back(operand);
      continue;
    }
    found.folders = true;
    const std::size_t first = found.paths.size();
    const std::size_t faults = found.faults.size();
    search(operand, found);
    std::sort(found.paths.begin() + std::ptrdiff_t(first), found.paths.end());
    std::sort(found.faults.begin() + std::ptrdiff_t(faults), found.faults.end());
    if (found.paths.size() == first && found.faults.size() == faults)
      found.faults.push_back(operand + ": no programs in this folder");
  }
  leaveOutRepeated(found);
  return found;
}

} // namespace arbiter::tools
