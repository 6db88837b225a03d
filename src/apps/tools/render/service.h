#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "control/frames.h"
#include "control/server.h"

namespace arbiter::tools {

/// Receives the renderer's requests on the socket's thread and queues them for the drawing thread.
/// If several texts wait, only the newest is drawn. `hello` and `ping` are answered at once.
class RenderService final : public control::Service {
public:
  explicit RenderService(control::Server &server) : m_server(server) {}

  struct Waiting {
    control::ClientId client = 0;
    control::Request request;
  };

  // --- The thread that draws ---

  /// Returns the next request; nothing if none arrives in time, or if the clients have gone.
  [[nodiscard]] std::optional<Waiting>
  next(std::optional<std::chrono::steady_clock::time_point> until);
  [[nodiscard]] bool isOver() const { return m_over; }
  void endService() { // no more clients will connect
    const std::lock_guard lock(m_mutex);
    m_over = true;
    m_wake.notify_all();
  }
  void answer(const Waiting &to, const control::Answer &answer);
  void wantFrames(control::ClientId client, std::uint32_t every);
  /// True if a client wants frames and has a free slot.
  [[nodiscard]] bool wantsFrame(int width, int height);
  /// Returns the memory for the next frame's pixels, valid until lend(), or null if no frame is
  /// wanted.
  [[nodiscard]] std::uint8_t *beginFrame(int width, int height);
  void lend(control::Json params);
  /// Marks the start of a request's work.
  void setAtWork(std::int64_t revision);
  void setIdle();
  void noteFrame(std::int64_t number, std::int64_t revision);

  // --- The socket's thread ---

  void connected(control::ClientId client, pid_t process) override;
  void received(control::ClientId client, control::Request request) override;
  void disconnected(control::ClientId client) override;
  void waited() override;
  [[nodiscard]] int patience() override;

private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] std::optional<control::Answer> atOnce(control::ClientId client,
                                                      const control::Request &request);
  void supersede();

  control::Server &m_server;
  std::mutex m_mutex; ///< guards the members below
  std::condition_variable m_wake;
  std::deque<Waiting> m_waiting;
  std::atomic<bool> m_over{false};
  /// Only the last client that wanted frames receives them.
  control::ClientId m_viewer = 0;
  std::uint32_t m_every = 0;
  std::uint64_t m_seen = 0;
  std::shared_ptr<control::FrameRing> m_ring;
  std::int64_t m_serial = 0;
  int m_slot = -1;
  std::optional<Clock::time_point> m_atWork;
  std::int64_t m_workRevision = 0, m_revision = 0, m_number = 0;
  int m_nextBusy = 0; ///< in ms
  std::optional<Clock::time_point> m_lastFrame;
};

} // namespace arbiter::tools
