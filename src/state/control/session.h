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

class Context;
class ShareGroup;

namespace remote {

using Clock = std::chrono::steady_clock;

/// The process's side of control: the clients, what they wait for, and what they have changed. A
/// thread of its own serves the socket and never calls GL; the application's threads answer where
/// their frames end.
class Session final : public wire::Service {
public:
  /// Null until begin().
  [[nodiscard]] static Session *instance() { return s_instance.load(std::memory_order_acquire); }
  /// Listens from now on, once in a process. Where it cannot, the log says why.
  static void begin();

  // --- The application's threads ---

  /// A frame ended, or something else was drawn by a context that ends none.
  void noteActivity(bool frame);
  /// Takes the time of a frame, while there are clients.
  void frameEnded();
  /// There are clients, or what one of them left is to be undone.
  [[nodiscard]] bool isBusy() const { return m_busy.load(std::memory_order_acquire); }
  /// When a frame last ended in any context.
  [[nodiscard]] bool endsFrames() const;
  /// Answers what waits. The context is current, outside Begin and lists.
  void serve(Context &context);
  /// Gives clients that want it the frame that is about to be shown.
  void lendFrame(Context &context);
  /// The frame has ended that the context's observer looked at, if there is one: its client is
  /// answered.
  void endObservation(Context &context);

  // --- For the methods, within serve() ---

  /// A fault where another client is the writer; this one is it from now on otherwise.
  [[nodiscard]] std::optional<wire::Fault> becomeWriter(wire::ClientId client);
  /// Of the id's last text; 0: none.
  [[nodiscard]] std::int64_t &revisionOf(const std::string &id) { return m_revisions[id]; }
  [[nodiscard]] std::vector<std::shared_ptr<ShareGroup>> groups();
  void wantFrames(wire::ClientId client, std::uint32_t every, int width, int height);
  /// The context's next frame is looked at; its request is answered at that frame's end, or, of a
  /// Hold, at its draw. A fault where one is looked at already.
  [[nodiscard]] std::optional<wire::Fault> observe(Context &context, Observation wish);
  [[nodiscard]] Tallies &tallies() { return m_tallies; }
  [[nodiscard]] const FrameTimes &frameTimes() const { return m_times; }
  [[nodiscard]] std::uint64_t frames() const { return m_frames.load(std::memory_order_relaxed); }

  /// Images that textures had before a client's took their place.
  struct OwnImage {
    BoundTexture texture;
    Picture own, written;
    std::weak_ptr<ShareGroup> group;
    std::uint32_t context = 0; ///< serial
    bool stale = false;        ///< to be put back
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
    std::uint32_t every = 0; ///< frames: 0 wants none
    int width = 0, height = 0;
    std::uint64_t seen = 0; ///< frames that ended since it wanted some
    std::shared_ptr<wire::FrameRing> ring;
    std::int64_t serial = 0; ///< of `ring`
  };
  Session(std::unique_ptr<wire::Server> server, std::string path);
  static void serveSocket(void *self);
  static void afterFork();
  [[nodiscard]] bool answerAtOnce(wire::ClientId client, const wire::Request &request);
  [[nodiscard]] wire::Json ping() const;
  void release(wire::ClientId client, const wire::Json &params);
  void updateBusy();
  void join(Context &context);
  void undo(Context &context);
  void tellLoaded();
  [[nodiscard]] std::deque<Waiting> takeWaiting();
  void hold(DrawObserver &observer, const ObservedDraw &draw, const Redraw &redraw);
  [[nodiscard]] std::optional<Waiting> nextOfHold(wire::ClientId client, Clock::time_point until);
  void lend(wire::ClientId id, const Picture &picture, const Context &context);

  static std::atomic<Session *> s_instance;
  const std::unique_ptr<wire::Server> m_server;
  const std::string m_path;

  std::mutex m_mutex; ///< what follows, down to the next mark
  std::deque<Waiting> m_waiting;
  std::map<wire::ClientId, Client> m_clients;
  std::optional<wire::ClientId> m_writer;
  bool m_undo = false, m_hasStale = false;
  int m_nextBusy = 0; ///< ms at which the next `busy` is said
  std::vector<std::weak_ptr<ShareGroup>> m_groups;
  std::unique_ptr<DrawObserver> m_observer; ///< of the context that is observed
  Clock::time_point m_observedSince;
  std::optional<wire::ClientId> m_holder; ///< whose draw is held: a thread waits for its requests
  std::condition_variable m_arrived;      ///< a request, or the end of a client

  std::atomic<bool> m_busy{false};
  std::atomic<std::uint64_t> m_frames{0};
  std::atomic<std::int64_t> m_active{0}, m_frameEnded{0}; ///< monotonic ms; 0: never

  std::mutex m_serving; ///< one thread answers at a time; what follows is its
  std::map<std::string, std::int64_t> m_revisions;
  std::vector<OwnImage> m_ownImages;
  Tallies m_tallies; ///< has a lock of its own
  FrameTimes m_times;
};

} // namespace remote
} // namespace arbiter::state
