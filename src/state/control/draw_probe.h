#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <GL/gl.h>

#include "host/host_table.h"
#include "state/programs/program_object.h"
#include "util/result.h"

namespace arbiter::state {

class Context;

namespace remote {

/// A draw of the application's, as often as it is wanted. It leaves GL's current values as the draw
/// does, and changes nothing else but pixels.
using Redraw = std::function<void(const host::HostTable &)>;

/// Pixels of the window, y up.
struct Region {
  int x = 0, y = 0, width = 1, height = 1;
};

/// Repeats draws to the window into colours of 32-bit floats, unblended, with the depths and
/// stencils that the draw finds. All state is put back. The context is current, outside Begin and
/// lists.
class DrawProbe {
public:
  static constexpr std::size_t kMostTargets = 4;

  struct Wish {
    Region region;
    std::size_t targets = 1;
    Vec4 clear{};                                   ///< where nothing is drawn
    std::shared_ptr<const CompiledProgram> program; ///< null: the application's own
    std::vector<Vec4> locals; ///< of `program`: its first local parameters, where not the draw's
    bool alphaTest = false;   ///< as the application has it; else fragments pass
  };

  /// \param host the functions that draw (not those that are observed)
  DrawProbe(Context &context, const host::HostTable &host) : m_context(context), m_host(host) {}
  /// The context is current.
  ~DrawProbe();
  DrawProbe(const DrawProbe &) = delete;
  DrawProbe &operator=(const DrawProbe &) = delete;

  /// targets * height * width values, the lowest row first. Errors: what the host refuses, in
  /// words.
  [[nodiscard]] Result<std::vector<Vec4>, std::string> draw(const Redraw &redraw, const Wish &wish);

private:
  [[nodiscard]] bool attach(const Wish &wish, GLenum depthFormat);
  [[nodiscard]] std::string copyDepths(const Wish &wish);
  void image(std::size_t index, int width, int height, GLenum format);
  [[nodiscard]] bool scissor(const Region &region);

  Context &m_context;
  const host::HostTable &m_host;
  bool m_made = false;
};

/// A program of a client's that shows values: checked, whatever a card's limits, and ready to be
/// drawn with. Errors: the compiler's, rendered.
[[nodiscard]] Result<std::shared_ptr<const CompiledProgram>, std::string>
compileProbe(const Context &context, const std::string &text);

/// Draws to a float target are possible in the context: null, or why not.
[[nodiscard]] const char *whyNoProbe(const Context &context);

} // namespace remote
} // namespace arbiter::state
