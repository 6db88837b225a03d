#pragma once
#include <array>
#include <memory>
#include <vector>

#include <GL/gl.h>

namespace arbiter::state {

class Context;
struct CompiledProgram;
struct ProgramPair;

/// The uses of the host's own ARB path. The application's GLSL program has one stage alone, and the
/// other one is an ARB program's: no GLSL program of the layer's can join one of the application's.
/// Or a program is so long that the host's GLSL compiler may not survive it. The host gets
/// assembly: from a program that our compiler checked, within our limits, and each in a host object
/// of its own, for a host may not survive one that is specified again and again.
class HostAssembly {
public:
  /// Binds and enables the programs of `pair` on the host, loading each at its first call; a stage
  /// that has none is released. False, with nothing bound, if the host refuses one. Raises no
  /// error.
  [[nodiscard]] bool apply(Context &context, const ProgramPair &pair);
  /// Gives the host the env and local values that the effective programs read.
  void uploadParameters(Context &context) const;
  /// Enables the host's fragment target with no program in it: each draw is the host's error then,
  /// as it would be the layer's. False if the host has no such target.
  [[nodiscard]] bool refuse(Context &context);
  [[nodiscard]] bool refuses() const { return m_refuses; }
  /// PopAttrib or CopyContext may have brought back an enable of the layer's on the host.
  void disableAgain(Context &context) const;
  /// Disables and unbinds what apply() bound.
  void release(Context &context);
  /// Empties without touching the host; gives the host objects' names.
  [[nodiscard]] std::vector<GLuint> abandon();
  [[nodiscard]] bool active() const { return m_active[0] || m_active[1] || m_refuses; }

private:
  struct Entry {
    std::shared_ptr<const CompiledProgram> compiled;
    GLuint name = 0; ///< 0: the host refused it
  };
  [[nodiscard]] GLuint nameOf(Context &context,
                              const std::shared_ptr<const CompiledProgram> &compiled);
  [[nodiscard]] bool applyStage(Context &context, std::size_t stage,
                                const std::shared_ptr<const CompiledProgram> &compiled);
  void releaseStage(Context &context, std::size_t stage);

  std::vector<Entry> m_entries;
  bool m_refuses = false;
  bool m_used = false; ///< the host's enables were ever set
  /// Vertex, fragment; null where the host's target is disabled.
  std::array<std::shared_ptr<const CompiledProgram>, 2> m_active;
};

} // namespace arbiter::state
