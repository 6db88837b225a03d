#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "control/client.h"
#include "util/result.h"

namespace arbiter::tools::ctl {

namespace wire = arbiter::control;

/// A message for standard error, and the exit code.
struct Failure {
  int code = 0;
  std::string message;
};

/// A connection to a controlled process.
class Connection {
public:
  /// Connects to a process.
  /// \param process 0: the only one that listens
  [[nodiscard]] static Result<std::unique_ptr<Connection>, Failure>
  open(pid_t process, std::chrono::milliseconds patience);

  Connection(pid_t process, wire::Descriptor fd, std::chrono::milliseconds patience)
      : m_process(process), m_client(std::move(fd)), m_patience(patience) {}

  /// Sends a request and returns its result. A failure's message says what the user can do.
  [[nodiscard]] Result<wire::Json, Failure> ask(const std::string &method, wire::Json params);
  /// Returns the next frame that the process shows.
  [[nodiscard]] Result<wire::Frame, Failure> frame();

  /// Waits until the connection has been open for that long, or has closed.
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
