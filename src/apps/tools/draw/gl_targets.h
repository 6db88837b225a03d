#pragma once
#include <epoxy/gl.h>
#include <optional>
#include <string>
#include <vector>

#include "apps/tools/draw/gl_queries.h"
#include "apps/tools/draw/renderer.h"

namespace arbiter::tools {

/// Owns framebuffer objects for the targets that passes of a document draw to.
class Targets {
public:
  Targets() = default;
  Targets(const Targets &) = delete;
  Targets &operator=(const Targets &) = delete;
  ~Targets();

  [[nodiscard]] std::optional<RenderError> load(const scene::Document &document);
  /// Makes a target the current framebuffer. An empty name restores the one that was current at
  /// load().
  void bind(const std::string &name) const;
  /// Returns a target's color or depth texture (2D), or 0 if there is no such target.
  [[nodiscard]] GLuint texture(const std::string &name, bool depth) const;

private:
  struct Target {
    std::string name;
    GLuint framebuffer = 0, color = 0, depth = 0;
  };

  [[nodiscard]] const Target *find(const std::string &name) const;
  std::optional<RenderError> add(std::size_t file, const scene::Target &spec);

  std::vector<Target> m_targets;
  GLuint m_outer = 0;
};

} // namespace arbiter::tools
