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

class Context;

namespace remote {

/// A draw of the application's, as often as it is wanted. It leaves GL's current values as the draw
/// does, and changes nothing else but pixels.
using Redraw = std::function<void(const host::HostTable &)>;

/// Repeats draws into colours of 32-bit floats, unblended, with the depths and stencils that the
/// draw finds. All state is put back. The context is current, outside Begin and lists, and its
/// attribute stack has room for one entry.
class DrawProbe {
public:
  static constexpr std::size_t kMostTargets = ProbeTarget::kMostColors;

  struct Wish {
    Region region;
    std::size_t targets = 1;
    Vec4 clear{};                                   ///< where nothing is drawn
    std::shared_ptr<const CompiledProgram> program; ///< null: the application's own
    std::vector<Vec4> locals; ///< of `program`: its first local parameters, where not the draw's
    GLuint depths = 0;        ///< the framebuffer that depths and stencils are copied from
    bool alphaTest = false;   ///< as the application has it; else fragments pass
  };

  /// \param host the functions that draw (not those that are observed)
  DrawProbe(Context &context, const host::HostTable &host)
      : m_context(context), m_host(host), m_target(context, host, ProbeTarget::Use::Values) {}

  /// targets * height * width values, the lowest row first. Errors: what the host refuses, in
  /// words.
  [[nodiscard]] Result<std::vector<Vec4>, std::string> draw(const Redraw &redraw, const Wish &wish);

private:
  [[nodiscard]] std::string bindTarget(const Wish &wish);

  Context &m_context;
  const host::HostTable &m_host;
  ProbeTarget m_target;
};

/// A program of a client's that shows values: checked, whatever a card's limits, and ready to be
/// drawn with. Errors: the compiler's, rendered.
[[nodiscard]] Result<std::shared_ptr<const CompiledProgram>, std::string>
compileProbe(const Context &context, const std::string &text);

/// Draws to a float target are possible in the context: null, or why not.
[[nodiscard]] const char *whyNoProbe(const Context &context);

} // namespace remote
} // namespace arbiter::state
