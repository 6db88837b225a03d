#pragma once
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/tools/debug/draws/channel.h"
#include "apps/tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// A drawer in another process, so that a crash of the driver cannot end this process.
class DrawClient : public Drawer {
public:
  /// Starts the process.
  /// \param name the drawer's name in reports
  /// \param start called in the new process, with the socket as descriptor 0; executes a command,
  /// and returns only if that fails
  [[nodiscard]] static Result<std::unique_ptr<DrawClient>, DebugError>
  start(std::string name, const std::function<void()> &start);
  ~DrawClient() override;

  /// Opens the document to draw, as the first request (draws/server.h).
  [[nodiscard]] std::optional<DebugError> open(const nlohmann::json &what);

  [[nodiscard]] std::string name() const override { return m_name; }
  [[nodiscard]] std::array<int, 2> size() const override { return m_size; }
  [[nodiscard]] Result<std::vector<Vec4>, DebugError>
  draw(const std::string &text, std::size_t targets, const Region &region,
       const std::vector<Vec4> &locals = {}) override;
  [[nodiscard]] Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
  picture(const Region &region) override;
  [[nodiscard]] Result<std::array<int, 3>, DebugError>
  textureSize(unsigned unit, fp::ir::TexTarget target) override;
  [[nodiscard]] Result<Vec4, DebugError> vertexState(const fp::ir::StateRef &state) override;
  /// True until the process has ended, or has failed to answer.
  [[nodiscard]] bool isAlive() const { return m_channel != nullptr; }
  /// Ends the process and waits for it.
  void close();

private:
  DrawClient(std::string name, int descriptor, int process);
  Result<nlohmann::json, DebugError> ask(const nlohmann::json &request);
  /// Sends a request whose answer is followed by `count` items.
  template <typename Item>
  Result<std::vector<Item>, DebugError> askItems(const nlohmann::json &request, std::size_t count);
  DebugError lost();

  std::string m_name;
  std::unique_ptr<Channel> m_channel;
  int m_process = -1;
  std::array<int, 2> m_size = {};
};

} // namespace arbiter::tools::debug
