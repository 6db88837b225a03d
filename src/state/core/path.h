#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace arbiter::state {

/// Who draws, and why the host draws untouched: the rows of paths.def.
enum class Path : std::uint8_t {
#define ARBITER_PATH(name, word, doc) name,
#include "state/core/paths.def"
#undef ARBITER_PATH
};

/// The words of the paths in statistics, captures and answers of control.
inline constexpr auto kPathNames = std::to_array<const char *>({
#define ARBITER_PATH(name, word, doc) word,
#include "state/core/paths.def"
#undef ARBITER_PATH
});
inline constexpr int kPathCount = int(kPathNames.size());
[[nodiscard]] constexpr const char *pathName(Path path) { return kPathNames[std::size_t(path)]; }

/// True if draws of this path are errors, or draw nothing.
[[nodiscard]] constexpr bool isDropped(Path path) {
  return path == Path::InvalidProgram || path == Path::HostRefused;
}

} // namespace arbiter::state
