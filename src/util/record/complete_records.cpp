#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <vector>

#include <dirent.h>
#include <sys/stat.h>

#include "util/record/live_record.h"

namespace arbiter {

namespace {

bool isNumber(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// True if `name` is the target `pattern`, in which %p stands for any number.
bool isTarget(std::string_view name, std::string_view pattern) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool escape = pattern[i] == '%' && i + 1 < pattern.size();
    if (escape && pattern[i + 1] == 'p') {
      std::size_t digits = 0;
      while (digits < name.size() && std::isdigit(static_cast<unsigned char>(name[digits])))
        ++digits;
      if (digits == 0)
        return false;
      name.remove_prefix(digits);
      ++i;
      continue;
    }
    i += escape && pattern[i + 1] == '%' ? 1 : 0;
    if (name.empty() || name[0] != pattern[i])
      return false;
    name.remove_prefix(1);
  }
  return name.empty();
}

/// Returns the process number in `name` if it is a record of the target `pattern`. Returns 0 if
/// not.
int processOf(std::string_view name, std::string_view pattern) {
  constexpr std::string_view kEnding = ".running";
  if (!name.ends_with(kEnding))
    return 0;
  name.remove_suffix(kEnding.size());
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos)
    return 0;
  const std::string number(name.substr(dot + 1));
  return isNumber(number) && isTarget(name.substr(0, dot), pattern) ? std::atoi(number.c_str()) : 0;
}

/// True if `name` is a report of the target `pattern`.
bool isReport(std::string_view name, std::string_view pattern) {
  constexpr int kMaxNumbers = 2; // TARGET.PID.N
  for (int i = 0; i <= kMaxNumbers; ++i) {
    if (isTarget(name, pattern))
      return true;
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || !isNumber(name.substr(dot + 1)))
      return false;
    name = name.substr(0, dot);
  }
  return false;
}

/// A pattern's folder, and the names in it.
struct Folder {
  explicit Folder(const std::string &pattern) {
    const std::size_t slash = pattern.rfind('/');
    prefix = slash == std::string::npos ? "" : pattern.substr(0, slash + 1);
    base = pattern.substr(prefix.size());
    DIR *const entries = ::opendir(prefix.empty() ? "." : prefix.c_str());
    if (!entries)
      return;
    while (const dirent *const entry = ::readdir(entries))
      names.emplace_back(entry->d_name);
    ::closedir(entries);
  }
  std::string prefix; ///< ends with a slash, or is empty
  std::string base;   ///< the pattern of names
  std::vector<std::string> names;
};

struct Found {
  std::string path;
  /// ns; the time of creation, as a record is written to as long as its process lives
  std::int64_t began;
};

} // namespace

int completeRecords(const std::string &pattern) {
  const Folder folder(pattern);
  std::vector<Found> found;
  for (const std::string &name : folder.names) {
    const int process = processOf(name, folder.base);
    if (process <= 0 || ::kill(process, 0) == 0 || errno != ESRCH)
      continue;
    const std::string path = folder.prefix + name;
    found.push_back({path, LiveRecord::beganAt(path)});
  }
  std::sort(found.begin(), found.end(),
            [](const Found &a, const Found &b) { return a.began < b.began; });
  int made = 0;
  for (const Found &record : found)
    made += LiveRecord::complete(record.path) ? 1 : 0;
  return made;
}

std::vector<std::string> reportsOf(const std::string &pattern) {
  const Folder folder(pattern);
  std::vector<std::string> paths;
  for (const std::string &name : folder.names)
    if (isReport(name, folder.base))
      paths.push_back(folder.prefix + name);
  std::sort(paths.begin(), paths.end());
  return paths;
}

} // namespace arbiter
