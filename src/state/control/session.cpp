#include "state/control/session.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <pthread.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "control/address.h"
#include "state/control/methods.h"
#include "state/core/control_hooks.h"
#include "state/programs/program_edits.h"
#include "state/raster_draw/raster_context.h"
#include "state/share/share_group.h"
#include "util/log.h"
#include "util/thread.h"

namespace arbiter::state::control {

namespace {

constexpr std::size_t kStack = std::size_t(512) << 10;
constexpr std::size_t kMaxWaiting = 64;
constexpr int kFirstBusy = 100; ///< ms

/// This process has tried to listen; it does not try again after a failure.
constinit std::atomic<bool> g_tried{false};

/// Used at the end of the process, where nothing may wait or allocate.
constinit char g_path[128] = "";
constinit pid_t g_process = 0;

void removeSocket() {
  if (g_path[0] != '\0' && g_process == getpid())
    unlink(g_path);
}

std::int64_t coarseMilliseconds() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC_COARSE, &time);
  return std::int64_t(time.tv_sec) * 1000 + time.tv_nsec / 1'000'000;
}

int millisecondsSince(Clock::time_point then) {
  return int(std::min<std::int64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - then).count(),
      1'000'000'000));
}

/// Returns the name of the process's executable.
std::string programName() { return program_invocation_short_name; }

} // namespace

constinit std::atomic<Session *> Session::s_instance{nullptr};

Session::Session(std::unique_ptr<wire::Server> server, std::string path)
    : m_server(std::move(server)), m_path(std::move(path)) {}

void Session::begin() {
  if (g_tried.load(std::memory_order_relaxed) || g_tried.exchange(true))
    return;
  const NoCancel scope;
  const auto folder = wire::socketFolder();
  if (!folder)
    return logError("control", "nothing listens: %s", folder.error().message.c_str());
  const std::string path = folder.value() + "/" + wire::socketName(getpid(), wire::Kind::Layer);
  auto listening = wire::listenAt(path);
  if (!listening)
    return logError("control", "nothing listens: %s", listening.error().message.c_str());
  std::unique_ptr<wire::Server> server =
      wire::Server::listening(std::move(listening.value()), path);
  // Never freed, as its thread runs until the process ends. A child of fork() makes its own.
  auto *const session = server ? new Session(std::move(server), path) : nullptr;
  if (!session || !startThread("arbiter-control", kStack, serveSocket, session))
    return logError("control", "nothing listens: no thread could be started");
  if (path.size() < sizeof g_path) {
    std::memcpy(g_path, path.c_str(), path.size() + 1);
    g_process = getpid();
  }
  static const bool s_registered =
      std::atexit(removeSocket) == 0 && pthread_atfork(nullptr, nullptr, afterFork) == 0;
  static_cast<void>(s_registered);
  ProgramEdits::instance().clear(); // edits of the parent, if this process was forked
  s_instance.store(session, std::memory_order_release);
  logInfo("control", "listening at %s", path.c_str());
}

void Session::afterFork() {
  if (Session *const parents = s_instance.exchange(nullptr))
    parents->m_server->closeAfterFork();
  g_observed = nullptr; // the parent observed a frame
  g_tried = false;
}

void Session::serveSocket(void *self) {
  auto &session = *static_cast<Session *>(self);
  for (;;) {
    try {
      session.m_server->run(session);
      return;
    } catch (const std::exception &) { // no memory: the message that was being read is lost
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
}

// --- The socket's thread ---

void Session::updateBusy() {
  m_busy.store(!m_clients.empty() || m_undo || m_hasStale, std::memory_order_release);
  ProgramEdits::instance().watchLoads(!m_clients.empty());
}

void Session::connected(wire::ClientId client, pid_t process) {
  const std::lock_guard lock(m_mutex);
  if (m_clients.empty())
    m_tallies.clear();
  m_clients[client].process = process;
  updateBusy();
}

void Session::disconnected(wire::ClientId client) {
  const std::lock_guard lock(m_mutex);
  m_clients.erase(client);
  std::erase_if(m_waiting, [client](const Waiting &waiting) { return waiting.client == client; });
  if (m_writer == client) {
    m_writer.reset();
    m_undo = true; // done by a thread that draws
  }
  updateBusy();
  m_arrived.notify_all();
}

wire::Json Session::ping() const {
  const std::int64_t active = m_active.load(std::memory_order_relaxed);
  wire::Json answer = wire::Json::object({{"frames", frames()}, {"idle", nullptr}});
  if (active != 0)
    answer["idle"] = std::max<std::int64_t>(coarseMilliseconds() - active, 0);
  return answer;
}

wire::Answer Session::release(wire::ClientId client, const wire::Json &object) {
  wire::Params params(object);
  const std::int64_t slot = params.integer("slot", 0, wire::kFrameSlots - 1);
  const std::lock_guard lock(m_mutex);
  const auto found = m_clients.find(client);
  const std::int64_t newest = found != m_clients.end() ? found->second.serial : 0;
  const std::int64_t serial = params.integer("serial", 0, INT64_MAX, newest);
  if (!params.ok())
    return params.fault();
  if (found != m_clients.end() && found->second.ring && serial == newest)
    found->second.ring->giveBack(int(slot));
  return wire::Json::object();
}

bool Session::answerAtOnce(wire::ClientId client, const wire::Request &request) {
  std::optional<wire::Answer> answer;
  if (request.method == "frame.release")
    answer = release(client, request.params);
  else if (request.method == "ping")
    answer = ping();
  else if (request.method == "hello")
    answer = helloAnswer(programName());
  else if (!isMethod(request.method))
    answer = wire::Fault{wire::kNoMethod, "there is no method " + request.method.substr(0, 80), {}};
  if (answer && request.wantsAnswer)
    m_server->send(client, wire::answerLine(request.id, *answer));
  return answer.has_value();
}

void Session::received(wire::ClientId client, wire::Request request) {
  if (answerAtOnce(client, request))
    return;
  const wire::Json id = request.id;
  const bool wantsAnswer = request.wantsAnswer;
  {
    const std::lock_guard lock(m_mutex);
    if (m_waiting.size() < kMaxWaiting) {
      m_waiting.push_back({client, std::move(request), Clock::now()});
      m_arrived.notify_all();
      return;
    }
  }
  if (wantsAnswer)
    m_server->send(
        client, wire::answerLine(id, wire::Fault{wire::kTooBusy, "64 requests wait already", {}}));
}

int Session::patience() {
  const std::lock_guard lock(m_mutex);
  if (m_waiting.empty()) {
    m_nextBusy = kFirstBusy;
    return -1;
  }
  return std::max(m_nextBusy - millisecondsSince(m_waiting.front().since), 0);
}

void Session::waited() {
  const std::lock_guard lock(m_mutex);
  if (m_waiting.empty())
    return;
  const int since = millisecondsSince(m_waiting.front().since);
  m_nextBusy = std::max(m_nextBusy, since) * 2;
  const std::string line = wire::eventLine("busy", wire::Json::object({{"milliseconds", since}}));
  std::vector<wire::ClientId> told;
  for (const Waiting &waiting : m_waiting) {
    if (std::find(told.begin(), told.end(), waiting.client) != told.end())
      continue;
    told.push_back(waiting.client);
    m_server->send(waiting.client, line);
  }
}

// --- The application's threads ---

void Session::noteActivity(bool frame) {
  const std::int64_t now = coarseMilliseconds();
  m_active.store(now, std::memory_order_relaxed);
  if (!frame)
    return;
  m_frames.fetch_add(1, std::memory_order_relaxed);
  m_frameEnded.store(now, std::memory_order_relaxed);
}

bool Session::endsFrames() const {
  constexpr std::int64_t kRecent = 1000; // ms
  const std::int64_t ended = m_frameEnded.load(std::memory_order_relaxed);
  return ended != 0 && coarseMilliseconds() - ended < kRecent;
}

void Session::join(RasterContext &context) {
  const std::lock_guard lock(m_mutex);
  std::erase_if(m_groups, [](const auto &group) { return group.expired(); });
  const auto isOurs = [&](const auto &group) { return group.lock() == context.group; };
  if (std::none_of(m_groups.begin(), m_groups.end(), isOurs))
    m_groups.push_back(context.group);
}

std::vector<std::shared_ptr<ShareGroup>> Session::groups() {
  const std::lock_guard lock(m_mutex);
  std::vector<std::shared_ptr<ShareGroup>> alive;
  for (const std::weak_ptr<ShareGroup> &each : m_groups)
    if (std::shared_ptr<ShareGroup> group = each.lock())
      alive.push_back(std::move(group));
  return alive;
}

std::optional<wire::Fault> Session::becomeWriter(wire::ClientId client) {
  const std::lock_guard lock(m_mutex);
  if (m_clients.find(client) == m_clients.end())
    return wire::Fault{wire::kNotPossible, "the client is gone", {}};
  if (!m_writer) {
    m_writer = client;
    m_revisions.clear();
  }
  if (*m_writer == client)
    return std::nullopt;
  const pid_t process = m_clients[*m_writer].process;
  return wire::Fault{wire::kOtherWriter,
                     "process " + std::to_string(process) + " changes things here already",
                     wire::Json::object({{"pid", process}})};
}

/// Undoes the changes of a writer that has disconnected.
void Session::undo(RasterContext &context) {
  bool ends = false;
  {
    const std::lock_guard lock(m_mutex);
    ends = std::exchange(m_undo, false);
    if (!ends && !m_hasStale)
      return;
  }
  if (ends) {
    ProgramEdits::instance().clear();
    for (OwnImage &image : m_ownImages)
      image.stale = true;
  }
  putBackStale(context, m_ownImages);
  const std::lock_guard lock(m_mutex);
  // Images of another share group wait for one of its contexts.
  m_hasStale = std::any_of(m_ownImages.begin(), m_ownImages.end(),
                           [](const OwnImage &image) { return image.stale; });
  updateBusy();
}

void Session::tellLoaded() {
  for (const std::string &name : ProgramEdits::instance().takeLoads()) {
    const std::string line = wire::eventLine("program.loaded", wire::Json::object({{"id", name}}));
    const std::lock_guard lock(m_mutex);
    for (const auto &[id, client] : m_clients)
      m_server->send(id, line);
  }
}

void Session::frameEnded() {
  const std::unique_lock serving(m_serving, std::try_to_lock);
  if (serving)
    m_times.frameEnded(nowNanoseconds());
}

/// Takes all requests, except those that the thread of a held draw waits for.
std::deque<Session::Waiting> Session::takeWaiting() {
  const std::lock_guard lock(m_mutex);
  std::deque<Waiting> taken, left;
  for (Waiting &each : m_waiting) {
    const bool isOfHold = m_holder == each.client && isMethodOfHold(each.request.method);
    (isOfHold ? left : taken).push_back(std::move(each));
  }
  m_waiting = std::move(left);
  return taken;
}

void Session::serve(RasterContext &context) {
  const std::unique_lock serving(m_serving, std::try_to_lock);
  if (!serving) // another thread is serving
    return;
  const NoCancel scope;
  join(context);
  undo(context);
  for (const Waiting &each : takeWaiting()) {
    const std::optional<wire::Answer> answer =
        answerRequest(*this, context, each.client, each.request);
    if (each.request.wantsAnswer && answer)
      m_server->send(each.client, wire::answerLine(each.request.id, *answer));
  }
  tellLoaded();
}

} // namespace arbiter::state::control
