#include "state/raster_draw/frames/back_off.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace arbiter::state {

void BackOff::enter(Phase phase) {
  m_phase = phase;
  m_frames = m_tried = 0;
  m_moving = m_plain = 0;
  m_others.restart();
}

void BackOff::tryAgain() {
  m_wasHost = m_phase == Phase::Host;
  m_looksAgain = m_phase == Phase::Host && !isStale();
  m_patience = isStale() ? std::min(2 * m_patience, kKeepFrames) : kLeastPatience;
  enter(Phase::TrySoftware);
}

namespace {

/// Returns the mean without the highest and the lowest quarter. If an application alternates
/// between two kinds of frames, a median would select one kind by chance.
float middleOf(float *values, int count) {
  std::sort(values, values + count);
  const int left = count > 2 ? std::max(count / 4, 1) : 0;
  return std::accumulate(values + left, values + count - left, 0.0f) / float(count - 2 * left);
}

} // namespace

BackOff::Side BackOff::tried() {
  const bool known = std::all_of(m_busy, m_busy + m_tried, [](float busy) { return busy > 0; });
  return {middleOf(m_times, m_tried), known ? middleOf(m_busy, m_tried) : 0};
}

bool BackOff::areSlower(float than) const {
  return m_tried >= kSureFrames && std::all_of(m_times, m_times + m_tried, [than](float time) {
           return time > than * kClearlySlower;
         });
}

bool BackOff::areFaster(float than) const {
  return m_tried >= kSureFrames && std::all_of(m_times, m_times + m_tried, [than](float time) {
           return time * kClearlySlower < than;
         });
}

bool BackOff::isHostFaster() const {
  const bool wait = m_host.waits() && m_software.waits();
  const float host = wait ? m_host.busy : m_host.time;
  return host * (m_triedMoving ? kFaster : 1 / kFaster) <
         (wait ? m_software.busy : m_software.time);
}

/// Compares the times of both sides and keeps the faster one.
void BackOff::decide() {
  ++m_statistics.trials;
  m_statistics.lastSoftwareMilliseconds = double(m_software.time);
  m_statistics.lastHostMilliseconds = double(m_host.time);
  const bool isHost = isHostFaster();
  m_keep = !isHost && m_host.time > m_software.time * kClearlySlower && m_keep >= kKeepFrames
               ? std::min(4 * m_keep, kMaxKeepFrames)
               : kKeepFrames;
  m_keepHost = kKeepFrames;
  m_others.decide(isHost ? m_host.time : m_software.time);
  enter(isHost ? Phase::Host : Phase::Software);
}

void BackOff::keepHost() {
  ++m_statistics.trials;
  m_statistics.lastSoftwareMilliseconds = double(tried().time);
  m_keepHost = std::min(2 * m_keepHost, kMaxHostFrames);
  enter(Phase::Host);
}

bool BackOff::isAnswered() const {
  if (m_tried == kTrialFrames)
    return true;
  switch (m_phase) {
  case Phase::TrySoftware:
    return m_looksAgain && areSlower(m_host.time);
  case Phase::TryHost:
    return areSlower(m_software.time) || areFaster(m_software.time);
  case Phase::Confirm:
    return areSlower(m_host.time);
  case Phase::Software:
  case Phase::Host:
    break;
  }
  return false;
}

void BackOff::answer() {
  if (m_phase == Phase::TrySoftware) {
    if (m_looksAgain && areSlower(m_host.time))
      return keepHost();
    m_software = tried();
    m_triedMoving = m_moving > kTrialFrames / 2;
    enter(Phase::TryHost);
  } else if (m_phase == Phase::TryHost) {
    m_host = tried();
    if (isHostFaster())
      enter(Phase::Confirm);
    else
      decide();
  } else {
    const Side again = tried();
    m_software = {std::min(m_software.time, again.time), std::min(m_software.busy, again.busy)};
    decide();
  }
}

void BackOff::frameEnded(Frame frame, std::chrono::steady_clock::time_point now) {
  if (m_forced)
    return;
  const float time =
      m_hasBefore ? std::chrono::duration<float, std::milli>(now - m_before).count() : 0.0f;
  const bool measured = m_hasBefore;
  const auto before = std::exchange(m_processorBefore, frame.processor);
  const float busy =
      before.count() != 0
          ? std::chrono::duration<float, std::milli>(frame.processor - before).count()
          : 0.0f;
  m_before = now;
  m_hasBefore = true;
  if (!engaged())
    ++m_statistics.framesBackedOff;
  ++m_frames;
  if (frame.keeps && m_phase != Phase::Host) {
    if (m_phase != Phase::Software)
      enter(Phase::Software);
    return;
  }
  switch (m_phase) {
  case Phase::Software:
    m_moving = frame.moved ? m_moving + 1 : 0;
    m_plain = frame.plain ? m_plain + 1 : 0;
    m_others.look(time);
    // The next trial waits for m_keep frames, also after one that the rasterizer won.
    if ((m_frames > m_keep || isStale()) && std::max(m_moving, m_plain) >= kDoubtFrames)
      tryAgain();
    break;
  case Phase::TrySoftware:
  case Phase::TryHost:
  case Phase::Confirm:
    m_moving += m_phase == Phase::TrySoftware && frame.moved ? 1 : 0;
    // The first frame after a change of sides pays for the change.
    if (m_frames > 1 && measured) {
      m_busy[m_tried] = busy;
      m_times[m_tried++] = time;
    }
    if (isAnswered())
      answer();
    break;
  case Phase::Host:
    m_others.look(time);
    if (m_frames > m_keepHost || isStale())
      tryAgain();
    break;
  }
}

} // namespace arbiter::state
