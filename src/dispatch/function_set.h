#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace arbiter::dispatch {

/// A set of the functions of a table of entry points. Applications that load GL by name ask for
/// thousands of names, so lookups must be fast. The set must be static, in the library of the
/// functions: it stores them as distances from itself, because writable memory must hold no
/// function pointers.
template <std::size_t kCount> class FunctionSet {
public:
  /// Builds the set. \param rows each with a member `function`
  template <typename Row> explicit FunctionSet(const Row (&rows)[kCount]) {
    std::transform(std::begin(rows), std::end(rows), m_sorted.begin(),
                   [&](const Row &row) { return std::int32_t(distanceOf(row.function)); });
    std::sort(m_sorted.begin(), m_sorted.end());
  }
  FunctionSet(const FunctionSet &) = delete;
  FunctionSet &operator=(const FunctionSet &) = delete;
  [[nodiscard]] bool contains(const void *function) const {
    using Limits = std::numeric_limits<std::int32_t>;
    const std::intptr_t distance = distanceOf(function);
    return distance >= Limits::min() && distance <= Limits::max() &&
           std::binary_search(m_sorted.begin(), m_sorted.end(), std::int32_t(distance));
  }

private:
  [[nodiscard]] std::intptr_t distanceOf(const void *function) const {
    return reinterpret_cast<std::intptr_t>(function) - reinterpret_cast<std::intptr_t>(this);
  }

  std::array<std::int32_t, kCount> m_sorted;
};
template <typename Row, std::size_t kCount>
FunctionSet(const Row (&)[kCount]) -> FunctionSet<kCount>;

} // namespace arbiter::dispatch
