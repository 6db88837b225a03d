#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "control/frames.h"
#include "control/server.h"
#include "state/control/draw_observer.h"
#include "state/control/host_pixels.h"
#include "state/control/tallies.h"

namespace arbiter::state {

struct RasterContext;
class ShareGroup;

namespace control {

using Clock = std::chrono::steady_clock;

/// The process's side of control: the clients, their requests, and what they have changed. Its own
/// thread serves the socket and never calls GL. The application's threads execute requests when
/// their frames end.
class Session final : public wire::Service {
public:
  /// Returns the session; null before begin().
  [[nodiscard]] static Session *instance() { return s_instance.load(std::memory_order_acquire); }
  /// Starts to listen, once per process. Logs why if it fails.
  static void begin();

  // --- The application's threads ---

  /// Notes the end of a frame, or a draw in a context that ends none.
  void noteActivity(bool frame);
  /// Measures the time of a frame, while there are clients.
  void frameEnded();
  /// True if there are clients, or changes of one to undo.
  [[nodiscard]] bool isBusy() const { return m_busy.load(std::memory_order_acquire); }
  /// True if any context has ended a frame lately.
  [[nodiscard]] bool endsFrames() const;
  /// Executes waiting requests. The context must be current, outside Begin and lists.
  void serve(RasterContext &context);
  /// Sends the frame that is about to be shown to the clients that want it.
  void lendFrame(RasterContext &context);
  /// Ends the observation of the context's frame, if there is one, and answers its client.
  void endObservation(RasterContext &context);

  // --- For the methods, within serve() ---

  /// Makes the client the writer. Returns a fault if another client is.
  [[nodiscard]] std::optional<wire::Fault> becomeWriter(wire::ClientId client);
  /// Returns the revision of the id's last text; 0: none.
  [[nodiscard]] std::int64_t &revisionOf(const std::string &id) { return m_revisions[id]; }
  [[nodiscard]] std::vector<std::shared_ptr<ShareGroup>> groups();
  void wantFrames(wire::ClientId client, std::uint32_t every, int width, int height);
  /// Observes the context's next frame. The request is answered at the frame's end, or at the draw
  /// of a Hold. Returns a fault if a frame is being observed already.
  [[nodiscard]] std::optional<wire::Fault> observe(RasterContext &context, Observation wish);
  [[nodiscard]] Tallies &tallies() { return m_tallies; }
  [[nodiscard]] const FrameTimes &frameTimes() const { return m_times; }
  [[nodiscard]] std::uint64_t frames() const { return m_frames.load(std::memory_order_relaxed); }

  /// The image that a texture had before a client's replaced it.
  struct OwnImage {
    BoundTexture texture;
    Picture own, written;
    std::weak_ptr<ShareGroup> group;
    std::uint32_t context = 0; ///< its serial number
    bool stale = false;        ///< to be restored
  };
  [[nodiscard]] std::vector<OwnImage> &ownImages() { return m_ownImages; }

  // --- The socket's thread ---

  void connected(wire::ClientId client, pid_t process) override;
  void received(wire::ClientId client, wire::Request request) override;
  void disconnected(wire::ClientId client) override;
  void waited() override;
  [[nodiscard]] int patience() override;

private:
  struct Waiting {
    wire::ClientId client;
    wire::Request request;
    Clock::time_point since;
  };
  struct Client {
    pid_t process = 0;
    std::uint32_t every = 0; ///< interval in frames; 0: wants none
    int width = 0, height = 0;
    std::uint64_t seen = 0; ///< frames since the client wanted some
    std::shared_ptr<wire::FrameRing> ring;
    std::int64_t serial = 0; ///< of `ring`
  };
  Session(std::unique_ptr<wire::Server> server, std::string path);
  static void serveSocket(void *self);
  static void afterFork();
  [[nodiscard]] bool answerAtOnce(wire::ClientId client, const wire::Request &request);
  [[nodiscard]] wire::Json ping() const;
  [[nodiscard]] wire::Answer release(wire::ClientId client, const wire::Json &params);
  void updateBusy();
  void join(RasterContext &context);
  void undo(RasterContext &context);
  void tellLoaded();
  [[nodiscard]] std::deque<Waiting> takeWaiting();
  void hold(DrawObserver &observer, const ObservedDraw &draw, const Redraw &redraw);
  [[nodiscard]] std::optional<Waiting> nextOfHold(wire::ClientId client, Clock::time_point until);
  void lend(wire::ClientId id, const Picture &picture, const RasterContext &context);

  static std::atomic<Session *> s_instance;
  const std::unique_ptr<wire::Server> m_server;
  const std::string m_path;

  std::mutex m_mutex; ///< guards the members before m_arrived
  std::deque<Waiting> m_waiting;
  std::map<wire::ClientId, Client> m_clients;
  std::optional<wire::ClientId> m_writer;
  bool m_undo = false, m_hasStale = false;
  int m_nextBusy = 0; ///< ms after which the next `busy` is sent
  std::vector<std::weak_ptr<ShareGroup>> m_groups;
  std::unique_ptr<DrawObserver> m_observer; ///< of the observed context
  Clock::time_point m_observedSince;
  std::optional<wire::ClientId> m_holder; ///< its draw is held, and a thread waits for its requests
  std::condition_variable m_arrived;      ///< signals a request, or a client's end

  std::atomic<bool> m_busy{false};
  std::atomic<std::uint64_t> m_frames{0};
  std::atomic<std::int64_t> m_active{0}, m_frameEnded{0}; ///< monotonic ms; 0: never

  std::mutex m_serving; ///< serialises serve(), which alone uses the members below
  std::map<std::string, std::int64_t> m_revisions;
  std::vector<OwnImage> m_ownImages;
  Tallies m_tallies; ///< has its own lock
  FrameTimes m_times;
};

} // namespace control
} // namespace arbiter::state
