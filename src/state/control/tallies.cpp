#include "state/control/tallies.h"

#include <algorithm>
#include <ctime>
#include <utility>

namespace arbiter::state::control {

void Tallies::begin(std::uint32_t context, Begun begun) {
  const std::lock_guard lock(m_mutex);
  m_begun[context] = std::move(begun);
}

/// Adds draws to the programs' tallies. The lock must be held.
void Tallies::add(const Begun &begun, std::uint64_t draws, std::uint64_t rasterized) {
  const std::uint64_t count = draws - begun.drawsBefore;
  if (count == 0)
    return;
  const auto time = std::uint64_t(nowNanoseconds() - begun.since);
  for (const std::string &program : begun.programs) {
    if (program.empty())
      continue;
    ProgramTally &tally = m_programs[program];
    tally.draws += count;
    tally.rasterized += rasterized - begun.rasterizedBefore;
    tally.nanoseconds += time;
  }
}

std::map<std::string, ProgramTally> Tallies::all() const {
  const std::lock_guard lock(m_mutex);
  return m_programs;
}

void Tallies::clear() {
  const std::lock_guard lock(m_mutex);
  m_programs.clear();
  m_begun.clear();
}

void FrameTimes::frameEnded(std::int64_t nanoseconds) {
  if (m_last != 0) {
    m_times[m_next] = nanoseconds - m_last;
    m_next = (m_next + 1) % m_times.size();
    m_count = std::min(m_count + 1, m_times.size());
  }
  m_last = nanoseconds;
}

double FrameTimes::of(std::size_t age) const {
  return double(m_times[(m_next + m_times.size() - 1 - age) % m_times.size()]) * 1e-6;
}

double FrameTimes::last() const { return m_count == 0 ? 0 : of(0); }

double FrameTimes::mean() const {
  double sum = 0;
  for (std::size_t i = 0; i < m_count; ++i)
    sum += of(i);
  return m_count == 0 ? 0 : sum / double(m_count);
}

double FrameTimes::worst() const {
  double most = 0;
  for (std::size_t i = 0; i < m_count; ++i)
    most = std::max(most, of(i));
  return most;
}

std::int64_t nowNanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

} // namespace arbiter::state::control
