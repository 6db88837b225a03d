#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace arbiter::state::control {

/// The counts of one program, while there are clients.
struct ProgramTally {
  std::uint64_t draws = 0;
  std::uint64_t rasterized = 0; ///< how many of them the rasterizer drew
  /// Time of the application's thread while the program was effective, ns.
  std::uint64_t nanoseconds = 0;
};

/// Draws and time per program, by the file name of its text. Any thread may call it.
class Tallies {
public:
  /// A context's effective programs, and its counters when they became effective.
  struct Begun {
    std::array<std::string, 2> programs; ///< empty: no program of that stage
    std::uint64_t drawsBefore = 0;       ///< draws on the path
    std::size_t path = 0;
    std::int64_t since = 0;             ///< monotonic ns
    std::uint64_t rasterizedBefore = 0; ///< draws of the rasterizer
  };
  void begin(std::uint32_t context, Begun begun);
  /// Adds the draws since begin().
  /// \param draws returns the present draws of a path
  /// \param rasterized the rasterizer's present draws
  template <typename Draws>
  void end(std::uint32_t context, Draws draws, std::uint64_t rasterized = 0) {
    const std::lock_guard lock(m_mutex);
    const auto found = m_begun.find(context);
    if (found == m_begun.end())
      return;
    add(found->second, draws(found->second.path), rasterized);
    m_begun.erase(found);
  }
  [[nodiscard]] std::map<std::string, ProgramTally> all() const;
  void clear();

private:
  void add(const Begun &begun, std::uint64_t draws, std::uint64_t rasterized);
  mutable std::mutex m_mutex;
  std::map<std::string, ProgramTally> m_programs;
  std::map<std::uint32_t, Begun> m_begun; ///< by the context's serial number
};

/// The times of the last 64 frames, from end to end.
class FrameTimes {
public:
  void frameEnded(std::int64_t nanoseconds);
  [[nodiscard]] std::size_t count() const { return m_count; }
  /// Returns the time of a frame in ms. \param age 0: the last one. Requires: age < count().
  [[nodiscard]] double of(std::size_t age) const;
  [[nodiscard]] double last() const; ///< ms; 0: none yet
  [[nodiscard]] double mean() const;
  [[nodiscard]] double worst() const;

private:
  std::array<std::int64_t, 64> m_times{};
  std::size_t m_next = 0, m_count = 0;
  std::int64_t m_last = 0; ///< monotonic ns; 0: none
};

/// Returns the monotonic time in ns.
[[nodiscard]] std::int64_t nowNanoseconds();

} // namespace arbiter::state::control
