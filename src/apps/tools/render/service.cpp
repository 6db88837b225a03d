#include "apps/tools/render/service.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <cerrno>
#include <unistd.h>

#include "apps/tools/render/methods.h"

namespace arbiter::tools {

namespace {

using control::Json;

constexpr std::size_t kMaxWaiting = 64;
constexpr int kFirstBusy = 100; ///< in ms

int millisecondsSince(std::chrono::steady_clock::time_point then) {
  return int(
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - then)
          .count());
}

} // namespace

// --- The thread that draws ---

std::optional<RenderService::Waiting> RenderService::next(std::optional<Clock::time_point> until) {
  std::unique_lock lock(m_mutex);
  const auto ready = [this] { return m_over || !m_waiting.empty(); };
  if (until)
    m_wake.wait_until(lock, *until, ready);
  else
    m_wake.wait(lock, ready);
  if (m_over || m_waiting.empty())
    return std::nullopt;
  Waiting first = std::move(m_waiting.front());
  m_waiting.pop_front();
  return first;
}

void RenderService::answer(const Waiting &to, const control::Answer &answer) {
  if (to.request.wantsAnswer)
    m_server.send(to.client, control::answerLine(to.request.id, answer));
}

void RenderService::wantFrames(control::ClientId client, std::uint32_t every) {
  const std::lock_guard lock(m_mutex);
  if (m_viewer != client)
    m_ring.reset();
  m_viewer = client;
  m_every = every;
  m_seen = 0;
}

bool RenderService::wantsFrame(int width, int height) {
  const std::lock_guard lock(m_mutex);
  const bool fits = m_ring && m_ring->layout().width == width && m_ring->layout().height == height;
  return m_every != 0 && !(fits && m_ring->isFull());
}

std::uint8_t *RenderService::beginFrame(int width, int height) {
  const std::lock_guard lock(m_mutex);
  if (m_every == 0 || m_seen++ % m_every != 0)
    return nullptr;
  if (!m_ring || m_ring->layout().width != width || m_ring->layout().height != height) {
    m_ring = control::FrameRing::make(width, height);
    if (!m_ring)
      return nullptr;
    m_server.send(m_viewer, control::bufferLine(m_ring->layout(), ++m_serial), m_ring->share());
  }
  m_slot = m_ring->take();
  return m_slot < 0 ? nullptr : m_ring->pixels(m_slot);
}

void RenderService::lend(Json params) {
  const std::lock_guard lock(m_mutex);
  if (m_slot < 0 || !m_ring)
    return;
  params["serial"] = m_serial;
  params["slot"] = m_slot;
  params["width"] = m_ring->layout().width;
  params["height"] = m_ring->layout().height;
  m_slot = -1;
  m_server.send(m_viewer, control::eventLine("frame", std::move(params)));
}

void RenderService::setAtWork(std::int64_t revision) {
  const std::lock_guard lock(m_mutex);
  m_atWork = Clock::now();
  m_workRevision = revision;
  m_nextBusy = kFirstBusy;
  m_server.wake();
}

void RenderService::setIdle() {
  const std::lock_guard lock(m_mutex);
  m_atWork.reset();
}

void RenderService::noteFrame(std::int64_t number, std::int64_t revision) {
  const std::lock_guard lock(m_mutex);
  m_number = number;
  m_revision = revision;
  m_lastFrame = Clock::now();
}

// --- The socket's thread ---

void RenderService::connected(control::ClientId, pid_t) {}

void RenderService::disconnected(control::ClientId client) {
  const std::lock_guard lock(m_mutex);
  std::erase_if(m_waiting, [&](const Waiting &waiting) { return waiting.client == client; });
  if (m_viewer == client) {
    m_every = 0;
    m_viewer = 0;
    m_ring.reset();
  }
}

std::optional<control::Answer> RenderService::atOnce(control::ClientId client,
                                                     const control::Request &request) {
  if (request.method == "hello") {
    Json methods = Json::array({"hello", "ping", "frame.release"});
    for (const char *name : renderMethods())
      methods.push_back(name);
    return Json::object({{"protocol", control::kProtocol},
                         {"server", "renderer"},
                         {"version", ARBITER_VERSION_TEXT},
                         {"pid", getpid()},
                         {"program", program_invocation_short_name},
                         {"methods", std::move(methods)}});
  }
  if (request.method == "ping") {
    const std::lock_guard lock(m_mutex);
    Json answer = Json::object({{"frames", m_number}, {"revision", m_revision}});
    answer["idle"] = m_lastFrame ? Json(millisecondsSince(*m_lastFrame)) : Json();
    answer["busy"] = m_atWork ? Json(millisecondsSince(*m_atWork)) : Json();
    return answer;
  }
  if (request.method == "frame.release") {
    control::Params params(request.params);
    const std::int64_t slot = params.integer("slot", 0, control::kFrameSlots - 1);
    const std::lock_guard lock(m_mutex);
    const std::int64_t serial = params.integer("serial", 0, INT64_MAX, m_serial);
    if (!params.ok())
      return params.fault();
    if (client == m_viewer && m_ring && serial == m_serial)
      m_ring->giveBack(int(slot));
    m_wake.notify_all();
    return Json::object();
  }
  const auto &names = renderMethods();
  if (std::none_of(names.begin(), names.end(),
                   [&](const char *name) { return request.method == name; }))
    return control::Fault{
        control::kNoMethod, "there is no method " + request.method.substr(0, 80), {}};
  return std::nullopt;
}

/// Answers waiting texts that a newer one replaces. Requires: the lock is held.
void RenderService::supersede() {
  for (auto it = m_waiting.begin(); it != m_waiting.end();) {
    if (it->request.method != "scene.set") {
      ++it;
      continue;
    }
    control::Params params(it->request.params);
    const std::int64_t revision = params.integer("revision", 0, INT64_MAX, 0);
    answer(*it, Json::object({{"ok", false},
                              {"superseded", true},
                              {"revision", revision},
                              {"diagnostics", Json::array()}}));
    it = m_waiting.erase(it);
  }
}

void RenderService::received(control::ClientId client, control::Request request) {
  if (const auto answer = atOnce(client, request)) {
    if (request.wantsAnswer)
      m_server.send(client, control::answerLine(request.id, *answer));
    return;
  }
  const std::lock_guard lock(m_mutex);
  if (request.method == "scene.set")
    supersede();
  if (m_waiting.size() >= kMaxWaiting) {
    answer({client, std::move(request)},
           control::Fault{control::kTooBusy, "64 requests wait already", {}});
    return;
  }
  m_waiting.push_back({client, std::move(request)});
  m_wake.notify_all();
}

int RenderService::patience() {
  const std::lock_guard lock(m_mutex);
  return m_atWork ? std::max(m_nextBusy - millisecondsSince(*m_atWork), 0) : -1;
}

void RenderService::waited() {
  const std::lock_guard lock(m_mutex);
  if (!m_atWork)
    return;
  const int since = millisecondsSince(*m_atWork);
  if (since < m_nextBusy)
    return;
  m_nextBusy = since * 2;
  m_server.broadcast(control::eventLine(
      "busy", Json::object({{"revision", m_workRevision}, {"milliseconds", since}})));
}

} // namespace arbiter::tools
