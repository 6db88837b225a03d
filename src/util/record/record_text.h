#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// A text with places for counters, which are filled in later by a process that has the counters
/// and knows nothing of their meaning. Made with strings and vectors; filled in without an
/// allocation or a lock, as that happens where a process ends, perhaps in a signal's handler that
/// interrupted either.
namespace arbiter {

/// The text that stands for counter `index` until fillIn() puts its value there, in decimal.
[[nodiscard]] std::string counterPlace(unsigned index);

struct NamedCounter {
  const char *name;
  unsigned index;
};
/// A JSON object of those of the counters that are not zero when it is filled in.
/// \param depth of the object's members: two spaces each
[[nodiscard]] std::string nonZeroPlace(const std::vector<NamedCounter> &counters, int depth);

/// Takes what is written; false: it cannot.
struct TextSink {
  void *to;
  bool (*take)(void *to, const char *bytes, std::size_t size);
  bool operator()(std::string_view text) const { return take(to, text.data(), text.size()); }
};

/// Writes `text` with its places filled in. A place whose counter is not below `count` is 0.
bool fillIn(const TextSink &sink, std::string_view text, const std::uint64_t *counters,
            unsigned count);

} // namespace arbiter
