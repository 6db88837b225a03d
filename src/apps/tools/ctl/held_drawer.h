#pragma once
#include <string>

#include "apps/tools/ctl/connection.h"
#include "apps/tools/debug/draws/remote_drawer.h"

namespace arbiter::tools::ctl {

/// Lets the debugger draw other programs in an application's draw. The application has stopped
/// before the draw for this client (pixel.hold). It continues when the object is destroyed.
class HeldDrawer : public debug::RemoteDrawer {
public:
  /// \param held the answer to pixel.hold
  /// \param picture the pixel that the draw's own program produces
  HeldDrawer(Connection &connection, const Json &held, std::array<std::uint8_t, 4> picture);
  ~HeldDrawer() override;
  HeldDrawer(const HeldDrawer &) = delete;
  HeldDrawer &operator=(const HeldDrawer &) = delete;

  [[nodiscard]] std::string name() const override { return "host"; }
  [[nodiscard]] std::array<int, 2> size() const override { return m_size; }
  /// Returns the pixel of the constructor for every position.
  [[nodiscard]] Result<std::vector<std::array<std::uint8_t, 4>>, debug::DebugError>
  picture(const debug::Region &region) override;
  /// Returns an error, because only fragments can be traced in an application.
  [[nodiscard]] Result<Vec4, debug::DebugError> vertexState(const fp::ir::StateRef &state) override;

private:
  Result<Json, debug::DebugError> ask(const std::string &method, Json params) override;
  std::optional<debug::DebugError> take(const Json &answer, std::span<std::uint8_t> bytes) override;

  Connection &m_connection;
  std::array<int, 2> m_size = {};
  std::array<std::uint8_t, 4> m_picture = {};
};

} // namespace arbiter::tools::ctl
