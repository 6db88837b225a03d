#pragma once
#include <cassert>
#include <utility>
#include <variant>

namespace arbiter {

/// A value, or the error that occurred instead. Errors inside the project are values; no exception
/// leaves a room.
template <typename T, typename E> class [[nodiscard]] Result {
public:
  Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : m_state(std::in_place_index<1>, std::move(error)) {}

  [[nodiscard]] bool ok() const { return m_state.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// Requires ok().
  [[nodiscard]] T &value() & {
    assert(ok());
    return *std::get_if<0>(&m_state);
  }
  [[nodiscard]] const T &value() const & {
    assert(ok());
    return *std::get_if<0>(&m_state);
  }
  [[nodiscard]] T &&value() && {
    assert(ok());
    return std::move(*std::get_if<0>(&m_state));
  }
  /// Requires !ok().
  [[nodiscard]] const E &error() const {
    assert(!ok());
    return *std::get_if<1>(&m_state);
  }

private:
  std::variant<T, E> m_state;
};

} // namespace arbiter
