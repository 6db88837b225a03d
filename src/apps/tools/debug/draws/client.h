#pragma once
#include <functional>
#include <memory>
#include <string>

#include "apps/tools/debug/draws/remote_drawer.h"
#include "control/client.h"

namespace arbiter::tools::debug {

/// A drawer in another process, so that a crash of the driver cannot end this process.
class DrawClient : public RemoteDrawer {
public:
  /// Starts the process.
  /// \param name the drawer's name in reports
  /// \param work done by the new process, with the socket as descriptor 0; executes a command
  [[nodiscard]] static Result<std::unique_ptr<DrawClient>, DebugError>
  start(const std::string &name, const std::function<int()> &work);
  ~DrawClient() override { close(); }

  /// Opens the document to draw, as the first request (draws/server.h).
  [[nodiscard]] std::optional<DebugError> open(const Json &what);

  [[nodiscard]] std::string name() const override { return m_name; }
  [[nodiscard]] std::array<int, 2> size() const override { return m_size; }
  [[nodiscard]] Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
  picture(const Region &region) override;
  [[nodiscard]] Result<Vec4, DebugError> vertexState(const fp::ir::StateRef &state) override;
  /// True until the process has ended, or has failed to answer.
  [[nodiscard]] bool isAlive() const { return m_client != nullptr; }
  /// Ends the process and waits for it.
  void close();

private:
  DrawClient(const std::string &name, control::Descriptor socket, pid_t process);
  Result<Json, DebugError> ask(const std::string &method, Json params) override;
  std::optional<DebugError> take(const Json &answer, std::span<std::uint8_t> bytes) override;
  DebugError lost();
  [[nodiscard]] DebugError error(const std::string &what) const;

  std::string m_name;
  std::unique_ptr<control::Client> m_client;
  pid_t m_process;
  std::array<int, 2> m_size = {};
};

} // namespace arbiter::tools::debug
