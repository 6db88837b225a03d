#pragma once
#include <string>
#include <string_view>

namespace arbiter {

/// `path` as processes of every width may be told it: its last folder that is `lib`, what the
/// loader puts for $LIB in processes of this width ("lib/x86_64-linux-gnu"), is $LIB. The path
/// itself where `lib` is empty or no part of it.
[[nodiscard]] inline std::string forEveryWidth(const std::string &path, std::string_view lib) {
  const std::string folder = '/' + std::string(lib) + '/';
  const std::size_t at = lib.empty() ? std::string::npos : path.rfind(folder);
  return at == std::string::npos ? path
                                 : path.substr(0, at) + "/$LIB/" + path.substr(at + folder.size());
}

} // namespace arbiter
