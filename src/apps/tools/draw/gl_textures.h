#pragma once
#include <epoxy/gl.h>
#include <optional>
#include <vector>

#include "apps/tools/draw/gl_targets.h"
#include "apps/tools/draw/renderer.h"
#include "apps/tools/draw/uses.h"

namespace arbiter::tools {

/// Owns the textures of all passes of a document.
class Textures {
public:
  Textures() = default;
  Textures(const Textures &) = delete;
  Textures &operator=(const Textures &) = delete;
  ~Textures();

  /// Creates each image and uploads it for the target that the pass's programs sample. A sampled
  /// unit that no line names gets an image of its number.
  [[nodiscard]] std::optional<RenderError> load(const scene::Document &document,
                                                const Targets &targets);
  /// Binds the textures of the panel's pass to their units.
  void bind(int panel) const;
  /// Unbinds them, because other passes may leave these units without images.
  void release(int panel) const;
  /// Copies the current framebuffer into each feedback texture.
  void feed(int width, int height) const;

private:
  struct Unit {
    int panel = 0;
    unsigned number = 0;
    GLenum target = GL_TEXTURE_2D;
    GLuint name = 0;
    bool owned = true; ///< false for a target's texture, which outlives this object
    bool feedback = false;
    bool enabled = false; ///< true if glEnable(target) chooses what is sampled, because the
                          ///< language does not (ATI's shaders)
    const scene::TextureSpec *spec = nullptr; ///< null if no line names the unit
    bool compares = false;
  };

  std::optional<RenderError> loadUnit(const scene::Document &document, const scene::Pass &pass,
                                      const scene::TextureSpec &spec,
                                      const std::vector<Sampled> &samples, const Targets &targets);
  void addUnset(const scene::Document &document, const scene::Pass &pass,
                const std::vector<Sampled> &samples, unsigned units);
  std::optional<RenderError> upload(const scene::Document &document, Unit &unit);
  static void setParameters(const Unit &unit);

  std::vector<Unit> m_units;
};

} // namespace arbiter::tools
