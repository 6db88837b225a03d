#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// A text with places for counters. A process that has only the counters fills them in later,
/// without knowing their meaning. Making the text uses strings and vectors. Filling it in neither
/// allocates nor locks, as it runs where a process ends, perhaps in a signal handler that
/// interrupted malloc or a lock.
namespace arbiter {

/// Returns the text that stands for counter `index` until fillIn() replaces it with the decimal
/// value.
[[nodiscard]] std::string counterPlace(unsigned index);

struct NamedCounter {
  const char *name;
  unsigned index;
};
/// Returns the text for a JSON object of those counters that are not zero when it is filled in.
/// \param depth of the object's members, which are indented by two spaces for each level
[[nodiscard]] std::string nonZeroPlace(const std::vector<NamedCounter> &counters, int depth);

/// Receives the output; `take` returns false if it fails.
struct TextSink {
  void *to;
  bool (*take)(void *to, const char *bytes, std::size_t size);
  bool operator()(std::string_view text) const { return take(to, text.data(), text.size()); }
};

/// Writes `text` with its places filled in. A counter whose index is not below `count` reads as 0.
bool fillIn(const TextSink &sink, std::string_view text, const std::uint64_t *counters,
            unsigned count);

} // namespace arbiter
