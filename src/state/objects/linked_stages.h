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

/// What LinkProgram made of each program of a share group. The host tells which shaders are
/// attached, but an executable keeps those that were attached when it was linked.
class LinkedStages {
public:
  /// A LinkProgram of `program` with these shaders attached. Whether it succeeded is asked at the
  /// first use: the answer may have to wait for the host's compiler.
  void linked(GLuint program, GlslStages attached);
  /// Stages that are known without asking.
  void set(GLuint program, GlslStages executable);
  /// What is known is of no use any more.
  void forget(GLuint program);
  /// Empty for a program that was never linked from shaders.
  [[nodiscard]] std::optional<GlslStages> of(const host::HostTable &host, GLuint program);

private:
  struct Entry {
    GlslStages executable;
    std::optional<GlslStages> linked; ///< in place of `executable`, if the link succeeded
  };
  std::mutex m_mutex;
  std::unordered_map<GLuint, Entry> m_programs;
};

} // namespace arbiter::state
