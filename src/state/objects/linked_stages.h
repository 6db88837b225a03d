#pragma once
#include <cstdint>
#include <mutex>
#include <optional>
#include <unordered_map>

#include <GL/gl.h>

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

/// The stages that the application's own GLSL shades; ARB programs shade the others.
struct GlslStages {
  bool vertex = false;
  bool fragment = false;
  [[nodiscard]] bool none() const { return !vertex && !fragment; }
};

/// The stages of each linked program of a share group. The host tells which shaders are attached
/// now, but an executable consists of those that were attached when it was linked.
class LinkedStages {
public:
  /// Notes a LinkProgram with these shaders attached. Its success is queried at the first use,
  /// because the answer may have to wait for the host's compiler.
  void linked(GLuint program, GlslStages attached);
  /// Sets the stages of a program if they are known.
  void set(GLuint program, GlslStages executable);
  /// Forgets a program.
  void forget(GLuint program);
  /// Returns a program's stages, or nothing if it was never linked from shaders.
  [[nodiscard]] std::optional<GlslStages> of(const host::HostTable &host, GLuint program);

private:
  struct Entry {
    GlslStages executable;
    /// the stages that replace `executable` if the link succeeded
    std::optional<GlslStages> linked;
  };
  std::mutex m_mutex;
  std::unordered_map<GLuint, Entry> m_programs;
};

} // namespace arbiter::state
