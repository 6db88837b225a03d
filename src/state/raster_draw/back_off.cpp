#include "state/raster_draw/back_off.h"

#include <algorithm>
#include <iterator>

namespace arbiter::state::software {

void BackOff::enter(Phase phase) {
  m_phase = phase;
  m_frames = 0;
  m_moving = m_plain = 0;
}

/// Both ways have been tried: m_times holds the host's frames.
void BackOff::decide() {
  std::nth_element(std::begin(m_times), m_times + kTrialFrames / 2, std::end(m_times));
  const float host = m_times[kTrialFrames / 2];
  ++m_statistics.trials;
  m_statistics.lastSoftwareMilliseconds = double(m_softwareTime);
  m_statistics.lastHostMilliseconds = double(host);
  const bool isHost = host < m_softwareTime * kFaster;
  // The host is looked at again after as many frames each time: what it draws may be what changed.
  m_keep = !isHost && host > m_softwareTime * kClearlySlower && m_keep >= kKeepFrames
               ? std::min(4 * m_keep, kMostKeepFrames)
               : kKeepFrames;
  enter(isHost ? Phase::Host : Phase::Software);
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
  switch (m_phase) {
  case Phase::Software:
    m_moving = frame.moved ? m_moving + 1 : 0;
    m_plain = frame.plain ? m_plain + 1 : 0;
    // After a trial that was won the next one waits, too.
    if (++m_frames > m_keep && std::max(m_moving, m_plain) >= kDoubtFrames)
      enter(Phase::TrySoftware);
    break;
  case Phase::TrySoftware:
  case Phase::TryHost:
    // The first frame after a change of sides pays for the change.
    if (m_frames > 0 && measured)
      m_times[m_frames - 1] = time;
    if (++m_frames <= kTrialFrames)
      break;
    if (m_phase == Phase::TryHost) {
      decide();
      break;
    }
    std::nth_element(std::begin(m_times), m_times + kTrialFrames / 2, std::end(m_times));
    m_softwareTime = m_times[kTrialFrames / 2];
    enter(Phase::TryHost);
    break;
  case Phase::Host:
    if (++m_frames > kKeepFrames)
      enter(Phase::TrySoftware);
    break;
  }
}

} // namespace arbiter::state::software
