// Frames that are observed draw by draw, and draws at which the application stops for a client.
#include <algorithm>
#include <utility>

#include "state/control/methods.h"
#include "state/control/session.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"
#include "util/thread.h"

namespace arbiter::state::control {

namespace {

/// The time that an application stops for a client that sends no request.
constexpr std::chrono::seconds kPatience{2};
/// The time after which a context that ends no frame is given up.
constexpr std::chrono::seconds kGivenUp{10};
/// The time without a frame after which a context may be gone, if another one ends frames: players
/// make a new context when their film restarts. A context is surely gone if another has its
/// address.
constexpr std::chrono::milliseconds kMoved{500};

} // namespace

std::optional<wire::Fault> Session::observe(RasterContext &context, Observation wish) {
  if (context.host == &kRecordingHost) // trueHost stays set when that is over
    return wire::Fault{wire::kTooBusy, "a list or a primitive is recorded at the frame's end", {}};
  const std::lock_guard lock(m_mutex);
  if (m_observer && (m_holder || Clock::now() - m_observedSince < kGivenUp))
    return wire::Fault{wire::kTooBusy, "a frame is looked at for another request", {}};
  (void)m_observer.release(); // its context may be gone, or may draw again, so it is not freed
  m_observedSince = Clock::now();
  m_observer =
      std::make_unique<DrawObserver>(context, std::move(wish),
                                     [this](DrawObserver &frame, const ObservedDraw &draw,
                                            const Redraw &redraw) { hold(frame, draw, redraw); });
  return std::nullopt;
}

void Session::endObservation(RasterContext &context) {
  const NoCancel scope;
  std::unique_ptr<DrawObserver> observer;
  std::optional<Observation> moved;
  {
    const std::lock_guard lock(m_mutex);
    if (!m_observer)
      return;
    const bool isThere = &m_observer->context() == &context;
    if (isThere && m_observer->serial() == context.serial) {
      observer = std::move(m_observer);
    } else if (!m_holder && (isThere || Clock::now() - m_observedSince > kMoved)) {
      moved = m_observer->wish();
      (void)m_observer.release(); // its context may draw again, so it is not freed
    }
  }
  if (moved)
    (void)observe(context, std::move(*moved));
  if (!observer)
    return;
  const Observation &wish = observer->wish();
  if (wish.wantsAnswer && !observer->wasHeld())
    m_server->send(wish.client, wire::answerLine(wish.id, observedAnswer(*observer, frames())));
}

/// Waits for the client's next request about the held draw. Returns nothing if the client is gone
/// or sends none.
std::optional<Session::Waiting> Session::nextOfHold(wire::ClientId client,
                                                    Clock::time_point until) {
  std::unique_lock lock(m_mutex);
  const auto find = [&] {
    return std::find_if(m_waiting.begin(), m_waiting.end(), [&](const Waiting &each) {
      return each.client == client && isMethodOfHold(each.request.method);
    });
  };
  const auto isGone = [&] { return m_clients.find(client) == m_clients.end(); };
  m_arrived.wait_until(lock, until, [&] { return isGone() || find() != m_waiting.end(); });
  const auto found = find();
  if (isGone() || found == m_waiting.end())
    return std::nullopt;
  Waiting next = std::move(*found);
  m_waiting.erase(found);
  return next;
}

void Session::hold(DrawObserver &observer, const ObservedDraw &draw, const Redraw &redraw) {
  const NoCancel scope;
  const Observation &wish = observer.wish();
  {
    const std::lock_guard lock(m_mutex);
    m_holder = wish.client;
  }
  m_server->send(wish.client, wire::answerLine(wish.id, heldJson(observer, draw)));
  bool held = true;
  while (held) {
    const auto next = nextOfHold(wish.client, Clock::now() + kPatience);
    if (!next)
      break;
    const wire::Answer answer = answerOfHold(observer, redraw, next->request);
    if (next->request.wantsAnswer)
      m_server->send(wish.client, wire::answerLine(next->request.id, answer));
    held = next->request.method != "pixel.release";
  }
  const std::lock_guard lock(m_mutex);
  m_holder.reset();
}

} // namespace arbiter::state::control
