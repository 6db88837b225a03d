#pragma once
#include <cstdint>
#include <iterator>
#include <map>

namespace arbiter::state {

/// The used names of a 32-bit name space, without 0, kept as ranges: reserving a billion names
/// costs no more than one.
class NameRanges {
public:
  using Name = std::uint32_t;

  /// Reserves the lowest `count` free names in a row and returns the first. Returns 0 if there is
  /// no such row, or if `count` is 0.
  Name reserveRow(Name count) {
    std::uint64_t first = 1;
    for (const auto &[begin, end] : m_ranges) {
      if (begin - first >= count)
        break;
      first = end;
    }
    if (count == 0 || first + count > kEnd)
      return 0;
    insert(first, first + count);
    return Name(first);
  }

  /// Reserves `name`, which is not 0. Does nothing if it is reserved.
  void reserve(Name name) {
    if (!contains(name))
      insert(name, std::uint64_t(name) + 1);
  }

  void release(Name name) {
    const auto it = find(name);
    if (it == m_ranges.end())
      return;
    const auto [begin, end] = *it;
    m_ranges.erase(it);
    if (begin < name)
      m_ranges.emplace(begin, name);
    if (std::uint64_t(name) + 1 < end)
      m_ranges.emplace(std::uint64_t(name) + 1, end);
  }

  [[nodiscard]] bool contains(Name name) const { return find(name) != m_ranges.end(); }

private:
  /// From the first name to one past the last. Ranges do not touch.
  using Ranges = std::map<std::uint64_t, std::uint64_t>;
  static constexpr std::uint64_t kEnd = std::uint64_t(1) << 32;

  [[nodiscard]] Ranges::const_iterator find(Name name) const {
    auto it = m_ranges.upper_bound(name);
    if (it == m_ranges.begin())
      return m_ranges.end();
    --it;
    return name < it->second ? it : m_ranges.end();
  }

  void insert(std::uint64_t begin, std::uint64_t end) {
    auto next = m_ranges.lower_bound(begin);
    if (next != m_ranges.end() && next->first == end) {
      end = next->second;
      next = m_ranges.erase(next);
    }
    if (next != m_ranges.begin()) {
      const auto previous = std::prev(next);
      if (previous->second == begin) {
        previous->second = end;
        return;
      }
    }
    m_ranges.emplace(begin, end);
  }

  Ranges m_ranges;
};

} // namespace arbiter::state
