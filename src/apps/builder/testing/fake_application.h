#pragma once
#include <QStringList>
#include <QTemporaryDir>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "control/frames.h"
#include "control/server.h"

namespace arbiter::builder::testing {

/// A controlled application without GL. It listens as the layer would, in a folder of its own, and
/// has one fragment program, one parameter and one texture. A text with the word "wrong" is
/// invalid; one with "red" makes its green frames red. Like the layer it undoes all changes when
/// its client goes.
class FakeApplication : public control::Service {
public:
  FakeApplication();
  ~FakeApplication() override;
  FakeApplication(const FakeApplication &) = delete;
  FakeApplication &operator=(const FakeApplication &) = delete;

  static constexpr const char *kProgram = "00112233445566778899aabbccddeeff.fp";
  static constexpr const char *kText = "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND\n";
  static constexpr int kWidth = 4, kHeight = 2;

  /// Returns the text that replaces the program's own; empty: none.
  [[nodiscard]] std::string edit();
  /// Returns the present value of program.local[0].x.
  [[nodiscard]] double value();
  [[nodiscard]] int clients() const { return m_clients; }
  /// Returns the number of requests of a method so far.
  [[nodiscard]] int count(const std::string &method);
  /// Disconnects all clients.
  void end();
  /// Delays the answer to the next `program.set`.
  void setDelay(int milliseconds) { m_delay = milliseconds; }

  void connected(control::ClientId client, pid_t process) override;
  void received(control::ClientId client, control::Request request) override;
  void disconnected(control::ClientId client) override;

private:
  control::Answer answer(control::ClientId client, const control::Request &request);
  control::Answer setText(control::Params &params);
  void lend(control::ClientId client);

  QTemporaryDir m_folder;
  QByteArray m_before; ///< XDG_RUNTIME_DIR
  std::unique_ptr<control::Server> m_server;
  std::shared_ptr<control::FrameRing> m_ring;
  std::thread m_thread;
  std::atomic<int> m_clients{0}, m_delay{0};
  std::mutex m_mutex; ///< guards the members below
  std::string m_edit;
  double m_value = 0.25;
  bool m_held = false;
  QStringList m_methods;
};

} // namespace arbiter::builder::testing
