#pragma once
#include <memory>
#include <vector>

#include <GL/gl.h>

namespace arbiter::state {

class Context;
struct CompiledProgram;

/// The one use of the host's own ARB path: the application's GLSL program has vertices only, and
/// its fragments are an ARB program's. No GLSL program of ours can join one of the application's,
/// so the host gets the text itself: checked by our compiler, within our limits, and each text in a
/// host object of its own, for a host may not survive one that is specified again and again.
class HostAssembly {
public:
  /// Binds and enables the program on the host, loading it at the first call. False, with nothing
  /// bound, if the host refuses it. Raises no error.
  [[nodiscard]] bool apply(Context &context,
                           const std::shared_ptr<const CompiledProgram> &compiled);
  /// Gives the host the env and local values that the program in force reads.
  void uploadParameters(Context &context) const;
  /// Disables and unbinds what apply() bound.
  void release(Context &context);
  /// The name is one of ours, which the application does not know.
  [[nodiscard]] bool owns(GLuint name) const;
  /// Empties without touching the host; gives the host objects' names.
  [[nodiscard]] std::vector<GLuint> abandon();
  [[nodiscard]] bool active() const { return m_active != nullptr; }

private:
  struct Entry {
    std::shared_ptr<const CompiledProgram> compiled;
    GLuint name = 0; ///< 0: the host refused it
  };
  [[nodiscard]] Entry &entryOf(Context &context,
                               const std::shared_ptr<const CompiledProgram> &compiled);

  std::vector<Entry> m_entries;
  std::shared_ptr<const CompiledProgram> m_active;
};

} // namespace arbiter::state
