#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "control/client.h"
#include "util/result.h"

namespace arbiter::tools::ctl {

namespace wire = arbiter::control;

/// What is said on standard error, and the exit code that goes with it.
struct Failure {
  int code = 0;
  std::string message;
};

/// A process that listens, connected to.
class Connection {
public:
  /// \param process 0: the only one that listens
  [[nodiscard]] static Result<std::unique_ptr<Connection>, Failure>
  open(pid_t process, std::chrono::milliseconds patience);

  Connection(pid_t process, wire::Descriptor fd, std::chrono::milliseconds patience)
      : m_process(process), m_client(std::move(fd)), m_patience(patience) {}

  /// The result of a request; a fault becomes a sentence that says what can be done.
  [[nodiscard]] Result<wire::Json, Failure> ask(const std::string &method, wire::Json params);
  /// The next frame that the process shows.
  [[nodiscard]] Result<wire::Frame, Failure> frame();

  /// Waits until it has been open for so long, or is not any more.
  void awaitAge(std::chrono::milliseconds age);

  [[nodiscard]] wire::Client &client() { return m_client; }
  [[nodiscard]] pid_t process() const { return m_process; }

private:
  [[nodiscard]] Failure noAnswer();
  pid_t m_process;
  wire::Client m_client;
  std::chrono::milliseconds m_patience;
  std::chrono::steady_clock::time_point m_since = std::chrono::steady_clock::now();
};

} // namespace arbiter::tools::ctl
