#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// A binary form for plain structures: numbers in memory layout, sequences with their count in
/// front. It is for one build on one machine (a cache), not for exchange. A structure takes part
/// through `template <typename Archive> void fields(Archive &archive, T &value)`, which passes its
/// members to the archive. One function both writes and reads, so the two cannot differ.
///
///   template <typename A> void fields(A &archive, Point &point) {
///     auto &[x, y] = point; // a new member does not compile until it is added here
///     archive(x, y);
///   }
namespace arbiter {

namespace detail {
template <typename T>
inline constexpr bool kIsNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;
} // namespace detail

class ArchiveWriter {
public:
  template <typename... Ts> void operator()(const Ts &...values) { (write(values), ...); }
  [[nodiscard]] std::string take() { return std::move(m_bytes); }

private:
  template <typename T> void write(const T &value) {
    if constexpr (detail::kIsNumber<T>)
      m_bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
    else
      fields(*this, const_cast<T &>(value)); // fields() returns it as const
  }
  void write(const std::string &text) { write(std::string_view(text)); }
  void write(std::string_view text) {
    write(std::uint32_t(text.size()));
    m_bytes += text;
  }
  template <typename T> void write(const std::vector<T> &values) {
    write(std::uint32_t(values.size()));
    for (const T &value : values)
      write(value);
  }
  template <typename T, std::size_t N> void write(const std::array<T, N> &values) {
    for (const T &value : values)
      write(value);
  }
  template <typename T> void write(const std::optional<T> &value) {
    write(value.has_value());
    if (value)
      write(*value);
  }

  std::string m_bytes;
};

/// Reads what ArchiveWriter wrote. If bytes are missing, or a count exceeds them, good() becomes
/// false and values keep their initial state. Nothing is read or allocated beyond the bytes.
class ArchiveReader {
public:
  explicit ArchiveReader(std::string_view bytes) : m_rest(bytes) {}
  template <typename... Ts> void operator()(Ts &...values) { (read(values), ...); }
  /// True if no bytes were missing.
  [[nodiscard]] bool good() const { return m_good; }
  /// True if no bytes were missing and none are left.
  [[nodiscard]] bool complete() const { return m_good && m_rest.empty(); }
  void fail() {
    m_good = false;
    m_rest = {};
  }

private:
  template <typename T> void read(T &value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      read(byte);
      if (byte > 1) // a bool with another value is undefined behaviour for its reader
        fail();
      value = byte == 1;
    } else if constexpr (detail::kIsNumber<T>) {
      if (m_rest.size() < sizeof value)
        return fail();
      std::memcpy(&value, m_rest.data(), sizeof value);
      m_rest.remove_prefix(sizeof value);
    } else {
      fields(*this, value);
    }
  }
  void read(std::string &text) {
    const std::size_t size = readCount();
    text.assign(m_rest.substr(0, size));
    m_rest.remove_prefix(size);
  }
  template <typename T> void read(std::vector<T> &values) {
    values.resize(readCount());
    for (T &value : values) {
      if (!m_good)
        return;
      read(value);
    }
  }
  template <typename T, std::size_t N> void read(std::array<T, N> &values) {
    for (T &value : values)
      read(value);
  }
  template <typename T> void read(std::optional<T> &value) {
    bool present = false;
    read(present);
    if (present)
      read(value.emplace());
  }
  /// Reads a count of elements of at least one byte each. Returns 0 and fails if so many bytes do
  /// not follow.
  std::size_t readCount() {
    std::uint32_t count = 0;
    read(count);
    if (count <= m_rest.size())
      return count;
    fail();
    return 0;
  }

  std::string_view m_rest;
  bool m_good = true;
};

} // namespace arbiter
