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

/// A message from the server that answers no request.
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
  Json params;                          ///< of the event: number, revision, ...
};

/// The client's end of the control protocol. Only call(), await() and flush() wait; an event loop
/// watches fd() and calls receive(). Only one thread may use it.
class Client {
public:
  explicit Client(Descriptor connected);

  [[nodiscard]] int fd() const { return m_channel.fd(); }
  /// Returns false forever once the server is gone or has sent an invalid message.
  [[nodiscard]] bool connected() const { return !m_closed; }

  // --- Without waiting ---

  /// Sends a request; takeAnswer() returns its answer.
  /// \returns the request's id
  std::uint64_t request(std::string_view method, Json params = Json::object());
  /// Sends a request that is not answered.
  void notify(std::string_view method, Json params = Json::object());
  /// Reads what has arrived, and sends what is queued. Call it when fd() is readable, or writable
  /// while wantsToWrite().
  void receive();
  [[nodiscard]] bool wantsToWrite() const { return m_channel.wantsToWrite(); }
  /// Returns the answer to the request, once; nothing until it has arrived.
  [[nodiscard]] std::optional<Answer> takeAnswer(std::uint64_t id);
  /// Returns the next descriptor that came with an answer (attached.h), or an empty one.
  [[nodiscard]] Descriptor takeDescriptor() { return m_channel.takeDescriptor(); }
  /// Returns the next answer that no call() waits for, in order of arrival; nothing if there is
  /// none.
  [[nodiscard]] std::optional<std::pair<std::uint64_t, Answer>> nextAnswer();
  /// Returns the next event other than a frame; nothing if there is none.
  [[nodiscard]] std::optional<Event> nextEvent();
  /// Returns the newest frame, and nothing if none came since the last call. Earlier frames have
  /// been given back. A frame stays valid until it is released, even if the buffer changes.
  [[nodiscard]] std::optional<Frame> nextFrame();
  void release(const Frame &frame);

  // --- Waiting ---

  /// Sends a request and waits for its answer. A Fault with code 0 means that none came in time, or
  /// that the server is gone.
  [[nodiscard]] Answer call(std::string_view method, Json params, std::chrono::milliseconds atMost);
  /// Waits until something arrives.
  /// \returns false if nothing has arrived in time
  bool await(std::chrono::milliseconds atMost);
  /// Waits until something arrives, or a whole millisecond is not left.
  /// \returns false if the time is over, or the server is gone
  bool awaitUntil(std::chrono::steady_clock::time_point end);

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
  std::deque<std::shared_ptr<FrameView>> m_lent; ///< views of the frames that the caller holds
};

} // namespace arbiter::control
