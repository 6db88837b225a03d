#pragma once
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "control/channel.h"
#include "control/frames.h"
#include "control/message.h"

namespace arbiter::control {

/// A message of the server's that answers no request.
struct Event {
  std::string method;
  Json params;
};

/// A picture that the server lends.
struct Frame {
  const std::uint8_t *pixels = nullptr; ///< RGBA rows, bottom row first; valid until released
  int width = 0, height = 0;            ///< pixels
  std::size_t stride = 0;               ///< bytes from row to row
  std::int64_t slot = 0, serial = 0;    ///< for release()
  Json params;                          ///< of the event: number, revision ..
};

/// The client's end of control. Nothing waits but call() and flush(); an event loop watches fd()
/// and calls receive(). One thread.
class Client {
public:
  explicit Client(Descriptor connected);

  [[nodiscard]] int fd() const { return m_channel.fd(); }
  /// False once the server is gone or has sent what cannot be understood; it stays so.
  [[nodiscard]] bool connected() const { return !m_closed; }

  // --- Without waiting ---

  /// Sends a request; its answer is taken by takeAnswer(). \returns its id
  std::uint64_t request(std::string_view method, Json params = Json::object());
  /// A request that is not answered.
  void notify(std::string_view method, Json params = Json::object());
  /// Takes what has come, and sends what waits. Call it when fd() is readable, or writable while
  /// wantsToWrite().
  void receive();
  [[nodiscard]] bool wantsToWrite() const { return m_channel.wantsToWrite(); }
  /// The answer to the request, once; nothing while it has not come.
  [[nodiscard]] std::optional<Answer> takeAnswer(std::uint64_t id);
  /// Answers that no call() waits for, in the order in which they came. Nothing: none.
  [[nodiscard]] std::optional<std::pair<std::uint64_t, Answer>> nextAnswer();
  /// The next event but frames. Nothing: none.
  [[nodiscard]] std::optional<Event> nextEvent();
  /// The newest frame; those before it have been given back. Nothing: none since the last call.
  /// A frame stays valid until it is released, also where the buffer has changed since.
  [[nodiscard]] std::optional<Frame> nextFrame();
  void release(const Frame &frame);

  // --- Waiting ---

  /// Until the answer is there. A Fault of code 0: none came in time, or the server is gone.
  [[nodiscard]] Answer call(std::string_view method, Json params, std::chrono::milliseconds atMost);
  /// Until something has come, or for so long. \returns false if nothing has
  bool await(std::chrono::milliseconds atMost);

private:
  struct Buffer {
    std::int64_t serial = 0;
    std::shared_ptr<FrameView> view;
  };
  void send(std::string line);
  void take(Json message);
  void takeBuffer(const Json &params);
  void takeFrame(Json params);
  void giveBack(std::int64_t serial, std::int64_t slot);

  Channel m_channel;
  bool m_closed = false;
  std::uint64_t m_lastId = 0;
  std::deque<std::pair<std::uint64_t, Answer>> m_answers;
  std::deque<Event> m_events;
  Buffer m_buffer;
  std::optional<Frame> m_frame;
  std::shared_ptr<FrameView> m_frameView;        ///< of m_frame
  std::deque<std::shared_ptr<FrameView>> m_lent; ///< of frames that the caller has
};

} // namespace arbiter::control
