#include "util/defaults/program.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <dirent.h>
#include <optional>
#include <unistd.h>

#include "util/file.h"
#include "util/hash.h"
#include "util/text/letters.h"

namespace arbiter::defaults {

namespace {

constexpr std::size_t kMaxCommandLine = 2u << 20; // execve's default limit
constexpr std::size_t kMaxMaps = 16u << 20;
constexpr std::string_view kDeleted =
    " (deleted)"; // follows the link's text if the file was deleted

std::string_view lastPart(std::string_view path, const char *separators = "/") {
  const std::size_t at = path.find_last_of(separators);
  return at == std::string_view::npos ? path : path.substr(at + 1);
}

bool equalInAnyCase(std::string_view a, std::string_view b) {
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (lowerCase(a[i]) != lowerCase(b[i]))
      return false;
  return true;
}

bool isWindowsName(std::string_view word) {
  return word.size() > 4 && equalInAnyCase(word.substr(word.size() - 4), ".exe");
}

/// True if a name is `stem`, alone or followed by digits, or by '-' and more.
bool isOf(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem))
    return false;
  name.remove_prefix(stem.size());
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.front())))
    name.remove_prefix(1);
  return name.empty() || name.front() == '-';
}

/// True for loaders that are given the program's own file as a word.
bool isElfLoader(std::string_view name) {
  return isSystemLoader(name) || isOf(name, "box64") || isOf(name, "box86") ||
         name.starts_with("FEX") || name.starts_with("qemu-");
}

/// Returns the first word that is not an option. ld.so's options with a separate value are known.
/// Options of other loaders have their value behind '=' or in the environment.
std::string programWord(const std::vector<std::string> &words) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string &word = words[i];
    if (word == "--library-path" || word == "--preload" || word == "--argv0" || word == "--audit" ||
        word == "--inhibit-rpath" || word == "--glibc-hwcaps-prepend" ||
        word == "--glibc-hwcaps-mask")
      ++i;
    else if (!word.starts_with("-"))
      return word;
  }
  return {};
}

std::string realPath(const std::string &path) {
  char *const real = ::realpath(path.c_str(), nullptr);
  std::string result = real == nullptr ? "" : real;
  std::free(real);
  return result;
}

/// Returns the entry of a folder whose name matches in any case, the exact name first.
std::string entryInAnyCase(const std::string &folder, std::string_view name) {
  std::string exact = folder + "/" + std::string(name);
  if (::access(exact.c_str(), F_OK) == 0)
    return exact;
  DIR *const stream = ::opendir(folder.c_str());
  if (stream == nullptr)
    return {};
  std::string found;
  while (const dirent *const each = ::readdir(stream))
    if (found.empty() && equalInAnyCase(each->d_name, name))
      found = folder + "/" + each->d_name;
  ::closedir(stream);
  return found;
}

/// Translates "C:\games\q.exe" to a path in this file system. Wine's drives are links in the
/// prefix's folder dosdevices.
std::string fromDrive(const Facts &facts, std::string_view path) {
  const char *const prefix = facts.environment("WINEPREFIX");
  const char *const home = facts.environment("HOME");
  std::string found;
  if (prefix != nullptr && *prefix == '/')
    found = prefix;
  else if (home != nullptr && *home == '/')
    found = std::string(home) + "/.wine";
  else
    return {};
  found += std::string("/dosdevices/") + lowerCase(path[0]) + ":";
  for (path.remove_prefix(2); !path.empty() && !found.empty();) {
    const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
    if (end != 0)
      found = entryInAnyCase(found, path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return found.empty() ? found : realPath(found);
}

/// Returns the file of that name, in any case, that the process has loaded.
std::string loadedFile(const std::string &maps, std::string_view name) {
  std::string text;
  if (maps.empty() || !arbiter::readFile(maps.c_str(), kMaxMaps, text))
    return {};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::size_t slash = text.find('/', at);
    if (slash < end) {
      const std::string_view path = std::string_view(text).substr(slash, end - slash);
      if (equalInAnyCase(lastPart(path), name))
        return std::string(path);
    }
    at = end + 1;
  }
  return {};
}

void takeWindowsWord(Program &program, const Facts &facts, const std::string &word) {
  program.windows = lastPart(word, "/\\");
  const bool drive =
      word.size() > 2 && std::isalpha(static_cast<unsigned char>(word[0])) && word[1] == ':';
  program.windowsPath = drive ? fromDrive(facts, word) : realPath(word);
  // The word may be a bare name that Wine found by its own rules, or come from a folder that was
  // left since.
  if (program.windowsPath.empty())
    program.windowsPath = loadedFile(facts.mapped, program.windows);
}

} // namespace

bool isWine(std::string_view name) { return isOf(name, "wine"); }

bool isLoader(std::string_view name) { return isWine(name) || isElfLoader(name); }

bool isSystemLoader(std::string_view name) {
  return name.starts_with("ld-linux") || name.starts_with("ld-2.") || name == "ld.so";
}

Facts ownFacts() {
  Facts facts;
  char link[4096];
  const ssize_t length = ::readlink("/proc/self/exe", link, sizeof link);
  if (length > 0 && std::size_t(length) < sizeof link)
    facts.executable.assign(link, std::size_t(length));
  if (facts.executable.ends_with(kDeleted))
    facts.executable.resize(facts.executable.size() - kDeleted.size());
  std::string line;
  static_cast<void>(arbiter::readFile("/proc/self/cmdline", kMaxCommandLine, line));
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find('\0', at), line.size());
    facts.words.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  facts.environment = [](const char *name) -> const char * { return ::secure_getenv(name); };
  facts.mapped = "/proc/self/maps";
  return facts;
}

Program programOf(const Facts &facts) {
  Program program;
  program.path = facts.executable;
  program.name = lastPart(program.path);
  const bool loader = isLoader(program.name);
  if (isElfLoader(program.name)) {
    const std::string word = programWord(facts.words);
    if (const std::string real = word.empty() ? "" : realPath(word); !real.empty()) {
      program.path = real;
      program.name = lastPart(real);
    }
  }
  // Wine sets its process's name to the Windows program's. Before that, the program is a separate
  // word.
  for (std::size_t i = 0; i < facts.words.size() && program.windows.empty(); ++i)
    if ((i == 0 || loader) && isWindowsName(facts.words[i]))
      takeWindowsWord(program, facts, facts.words[i]);
  return program;
}

std::string hashOfFile(const std::string &path) {
  const std::optional<Hash128> hash = hashFile(path.c_str());
  return hash ? toHex(*hash) : std::string();
}

bool matches(std::string_view pattern, std::string_view text, bool anyCase) {
  // The position of the last `*`, and how much of the text it has matched so far.
  std::size_t star = std::string_view::npos, taken = 0, p = 0, t = 0;
  const auto same = [&](char a, char b) {
    return a == b || (anyCase && lowerCase(a) == lowerCase(b));
  };
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || same(pattern[p], text[t]))) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++taken;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*')
    ++p;
  return p == pattern.size();
}

} // namespace arbiter::defaults
