#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace arbiter::state::remote {

/// What is counted of one program, while there are clients.
struct ProgramTally {
  std::uint64_t draws = 0;
  std::uint64_t rasterized = 0; ///< of them, by the rasterizer
  /// Of the application's thread, between the program's becoming effective and its leaving, ns.
  std::uint64_t nanoseconds = 0;
};

/// Draws and time by program, by the name of the text's file. Any thread.
class Tallies {
public:
  /// The effective programs of a context, from when they became it.
  struct Begun {
    std::array<std::string, 2> programs; ///< empty: none of that stage
    std::uint64_t drawsBefore = 0;       ///< that took the path
    std::size_t path = 0;
    std::int64_t since = 0;             ///< monotonic ns
    std::uint64_t rasterizedBefore = 0; ///< draws of the rasterizer's
  };
  void begin(std::uint32_t context, Begun begun);
  /// \param draws that took the path, by now \param rasterized draws of the rasterizer's, by now
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
  std::map<std::uint32_t, Begun> m_begun; ///< by the context's serial
};

/// Times between the ends of frames, of the last 64.
class FrameTimes {
public:
  void frameEnded(std::int64_t nanoseconds);
  [[nodiscard]] std::size_t count() const { return m_count; }
  /// The time of a frame, ms. \param age 0: the last one. Requires: age < count().
  [[nodiscard]] double of(std::size_t age) const;
  [[nodiscard]] double last() const; ///< ms; 0: none yet
  [[nodiscard]] double mean() const;
  [[nodiscard]] double worst() const;

private:
  std::array<std::int64_t, 64> m_times{};
  std::size_t m_next = 0, m_count = 0;
  std::int64_t m_last = 0; ///< monotonic ns; 0: none
};

/// Now, monotonic ns.
[[nodiscard]] std::int64_t nowNanoseconds();

} // namespace arbiter::state::remote
