#pragma once
#include <string>
#include <string_view>

namespace arbiter {

/// Returns `path` in a form that is valid for processes of every word size: it replaces the last
/// folder that equals `lib` with $LIB. `lib` is what the loader puts for $LIB in processes of this
/// word size ("lib/x86_64-linux-gnu"). Returns the path unchanged if `lib` is empty or not part of
/// it.
[[nodiscard]] inline std::string forEveryWidth(const std::string &path, std::string_view lib) {
  const std::string folder = '/' + std::string(lib) + '/';
  const std::size_t at = lib.empty() ? std::string::npos : path.rfind(folder);
  return at == std::string::npos ? path
                                 : path.substr(0, at) + "/$LIB/" + path.substr(at + folder.size());
}

} // namespace arbiter
