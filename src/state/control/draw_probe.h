#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>

#include "host/host_table.h"
#include "state/control/probe_target.h"
#include "state/objects/program_object.h"
#include "util/result.h"

namespace arbiter::state {

struct RasterContext;

namespace control {

/// Repeats a draw of the application's, any number of times. It leaves GL's current values as the
/// draw does, and otherwise changes only pixels.
using Redraw = std::function<void(const host::HostTable &)>;

/// Repeats draws to 32-bit float colours, unblended, with the depths and stencils that the draw
/// finds. Restores all state. The context must be current, outside Begin and lists, with room for
/// one entry on its attribute stack.
class DrawProbe {
public:
  static constexpr std::size_t kMaxTargets = ProbeTarget::kMaxColors;

  struct Wish {
    Region region;
    std::size_t targets = 1;
    Vec4 clear{};                                   ///< the colour where nothing is drawn
    std::shared_ptr<const CompiledProgram> program; ///< null: the application's own
    std::vector<Vec4> locals; ///< override the draw's first local parameters for `program`
    GLuint depths = 0;        ///< the framebuffer to copy depths and stencils from
    bool alphaTest = false;   ///< keeps the application's alpha test; else it is off
  };

  /// \param host functions that draw without being observed
  DrawProbe(RasterContext &context, const host::HostTable &host)
      : m_context(context), m_host(host), m_target(context, host, ProbeTarget::Use::Values) {}

  /// Draws. Returns targets * height * width values, bottom row first, or the reason why the host
  /// refuses.
  [[nodiscard]] Result<std::vector<Vec4>, std::string> draw(const Redraw &redraw, const Wish &wish);

private:
  [[nodiscard]] std::string bindTarget(const Wish &wish);

  RasterContext &m_context;
  const host::HostTable &m_host;
  ProbeTarget m_target;
};

/// Compiles a client's program that shows values, without a card's limits. Returns the compiler's
/// messages if it fails.
[[nodiscard]] Result<std::shared_ptr<const CompiledProgram>, std::string>
compileProbe(const RasterContext &context, const std::string &text);

/// Returns why the context cannot draw to float targets; null if it can.
[[nodiscard]] const char *whyNoProbe(const RasterContext &context);

} // namespace control
} // namespace arbiter::state
