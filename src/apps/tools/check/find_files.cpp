#include "apps/tools/check/find_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>

#include "fp_compiler/file_programs.h"
#include "fp_compiler/front/lexer.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

/// A text with such a name and without a header has lost its header. The first names are also used
/// for GLSL and Cg.
constexpr std::string_view kShared[] = {".fp", ".vp", ".vfp"};
constexpr std::string_view kOwn[] = {".atifs", ".arbfp", ".arbvp", ".nvrc", ".nvts", ".vsp"};

/// A header is searched for only in this many bytes, which may begin with comments.
constexpr std::size_t kMaxHead = 64u << 10;

bool isOneOf(std::string_view extension, std::span<const std::string_view> extensions) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::string headOf(const fs::path &path) {
  std::string head(kMaxHead, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(file.gcount()));
  return head;
}

bool hasHeader(std::string_view head) {
  return fp::languageOfText(fp::programsOf(head).front().in(head)).has_value();
}

/// True if the text has function calls, as GLSL, Cg and HLSL do. Assembly has parentheses only in
/// comments and in NVIDIA's conditions.
bool isOfFunctions(std::string_view head) {
  fp::Lexer lexer(head, 0, fp::Words::Calls);
  for (fp::Token token = lexer.next(); token.kind != fp::TokenKind::EndOfText; token = lexer.next())
    if (token.kind == fp::TokenKind::OpenParen)
      return true;
  return false;
}

bool isProgram(const fs::directory_entry &entry) {
  std::error_code error;
  const std::string extension = entry.path().extension().string();
  const bool own = isOneOf(extension, kOwn);
  const bool named = own || isOneOf(extension, kShared);
  // A broken link with a program's name is reported as a program that cannot be read.
  if (!entry.is_regular_file(error))
    return named && entry.is_symlink(error) && !entry.exists(error);
  if (own)
    return true;
  const std::string head = headOf(entry.path());
  return hasHeader(head) || (named && !isOfFunctions(head));
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

/// Removes paths that name a file again, directly or in a folder, and adds a fault for each.
/// Otherwise a file would count twice, and standard input would be empty the second time.
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
