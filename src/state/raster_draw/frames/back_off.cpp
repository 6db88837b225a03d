#include "state/raster_draw/frames/back_off.h"

#include <algorithm>
#include <iterator>

namespace arbiter::state::software {

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

float BackOff::median() {
  float *const middle = m_times + m_tried / 2;
  std::nth_element(m_times, middle, m_times + m_tried);
  return *middle;
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
  return m_hostTime * (m_triedMoving ? kFaster : 1 / kFaster) < m_softwareTime;
}

/// Both ways have been tried.
void BackOff::decide() {
  const float host = m_hostTime;
  ++m_statistics.trials;
  m_statistics.lastSoftwareMilliseconds = double(m_softwareTime);
  m_statistics.lastHostMilliseconds = double(host);
  const bool isHost = isHostFaster();
  m_keep = !isHost && host > m_softwareTime * kClearlySlower && m_keep >= kKeepFrames
               ? std::min(4 * m_keep, kMostKeepFrames)
               : kKeepFrames;
  m_keepHost = kKeepFrames;
  m_others.decide(isHost ? host : m_softwareTime);
  enter(isHost ? Phase::Host : Phase::Software);
}

void BackOff::keepHost() {
  ++m_statistics.trials;
  m_statistics.lastSoftwareMilliseconds = double(median());
  m_keepHost = std::min(2 * m_keepHost, kMostHostFrames);
  enter(Phase::Host);
}

bool BackOff::isAnswered() const {
  if (m_tried == kTrialFrames)
    return true;
  switch (m_phase) {
  case Phase::TrySoftware:
    return m_looksAgain && areSlower(m_hostTime);
  case Phase::TryHost:
    return areSlower(m_softwareTime) || areFaster(m_softwareTime);
  case Phase::Confirm:
    return areSlower(m_hostTime);
  case Phase::Software:
  case Phase::Host:
    break;
  }
  return false;
}

void BackOff::answer() {
  if (m_phase == Phase::TrySoftware) {
    if (m_looksAgain && areSlower(m_hostTime))
      return keepHost();
    m_softwareTime = median();
    m_triedMoving = m_moving > kTrialFrames / 2;
    enter(Phase::TryHost);
  } else if (m_phase == Phase::TryHost) {
    m_hostTime = median();
    if (isHostFaster())
      enter(Phase::Confirm);
    else
      decide();
  } else {
    m_softwareTime = std::min(m_softwareTime, median());
    decide();
  }
}

void BackOff::frameEnded(Frame frame, std::chrono::steady_clock::time_point now) {
  if (m_forced)
    return;
  const float time =
      m_hasBefore ? std::chrono::duration<float, std::milli>(now - m_before).count() : 0.0f;
  const bool measured = m_hasBefore;
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
    // After a trial that was won the next one waits, too.
    if ((m_frames > m_keep || isStale()) && std::max(m_moving, m_plain) >= kDoubtFrames)
      tryAgain();
    break;
  case Phase::TrySoftware:
  case Phase::TryHost:
  case Phase::Confirm:
    m_moving += m_phase == Phase::TrySoftware && frame.moved ? 1 : 0;
    // The first frame after a change of sides pays for the change.
    if (m_frames > 1 && measured)
      m_times[m_tried++] = time;
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

} // namespace arbiter::state::software
