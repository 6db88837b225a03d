#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

namespace arbiter::dispatch {

/// The functions of a table of entry points, to ask whether one is among them. An application that
/// loads GL by name asks that of thousands.
template <std::size_t kCount> class FunctionSet {
public:
  /// \param rows each with a member `function`
  template <typename Row> explicit FunctionSet(const Row (&rows)[kCount]) {
    std::transform(std::begin(rows), std::end(rows), m_sorted.begin(),
                   [](const Row &row) -> const void * { return row.function; });
    std::sort(m_sorted.begin(), m_sorted.end(), std::less<>());
  }
  [[nodiscard]] bool contains(const void *function) const {
    return std::binary_search(m_sorted.begin(), m_sorted.end(), function, std::less<>());
  }

private:
  std::array<const void *, kCount> m_sorted;
};
template <typename Row, std::size_t kCount>
FunctionSet(const Row (&)[kCount]) -> FunctionSet<kCount>;

} // namespace arbiter::dispatch
