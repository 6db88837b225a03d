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

/// Returns the process number in `name` if it is a record of the target `pattern`, in which %p
/// stands for any number. Returns 0 if not.
int processOf(std::string_view name, std::string_view pattern) {
  constexpr std::string_view kEnding = ".running";
  if (!name.ends_with(kEnding))
    return 0;
  name.remove_suffix(kEnding.size());
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos)
    return 0;
  const std::string number(name.substr(dot + 1));
  name = name.substr(0, dot);
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool escape = pattern[i] == '%' && i + 1 < pattern.size();
    if (escape && pattern[i + 1] == 'p') {
      std::size_t digits = 0;
      while (digits < name.size() && std::isdigit(static_cast<unsigned char>(name[digits])))
        ++digits;
      if (digits == 0)
        return 0;
      name.remove_prefix(digits);
      ++i;
      continue;
    }
    i += escape && pattern[i + 1] == '%' ? 1 : 0;
    if (name.empty() || name[0] != pattern[i])
      return 0;
    name.remove_prefix(1);
  }
  const bool whole =
      name.empty() && !number.empty() &&
      std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c); });
  return whole ? std::atoi(number.c_str()) : 0;
}

struct Found {
  std::string path;
  /// ns; the time of creation, as a record is written to as long as its process lives
  std::int64_t began;
};

} // namespace

int completeRecords(const std::string &pattern) {
  const std::size_t slash = pattern.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : pattern.substr(0, slash + 1);
  const std::string_view base =
      std::string_view(pattern).substr(slash == std::string::npos ? 0 : slash + 1);
  DIR *const entries = ::opendir(folder.c_str());
  if (!entries)
    return 0;
  std::vector<Found> found;
  while (const dirent *const entry = ::readdir(entries)) {
    const int process = processOf(entry->d_name, base);
    if (process <= 0 || ::kill(process, 0) == 0 || errno != ESRCH)
      continue;
    const std::string path = slash == std::string::npos ? entry->d_name : folder + entry->d_name;
    found.push_back({path, LiveRecord::beganAt(path)});
  }
  ::closedir(entries);
  std::sort(found.begin(), found.end(),
            [](const Found &a, const Found &b) { return a.began < b.began; });
  int made = 0;
  for (const Found &record : found)
    made += LiveRecord::complete(record.path) ? 1 : 0;
  return made;
}

} // namespace arbiter
