#pragma once
#include <epoxy/gl.h>
#include <optional>
#include <vector>

#include "tools/draw/gl_targets.h"
#include "tools/draw/renderer.h"
#include "tools/draw/uses.h"

namespace arbiter::tools {

/// The textures of all passes of a document.
class Textures {
public:
  Textures() = default;
  Textures(const Textures &) = delete;
  Textures &operator=(const Textures &) = delete;
  ~Textures();

  /// Makes each image and gives it to GL, as what the pass's programs sample it as. A unit that
  /// they sample and no line names gets its number for an image.
  [[nodiscard]] std::optional<RenderError> load(const scene::Document &document,
                                                const Targets &targets);
  /// Binds what the pass of that panel has in its units.
  void bind(int panel) const;
  /// Leaves its units without images, for passes that have none there.
  void release(int panel) const;
  /// Copies the current framebuffer into each texture that is feedback.
  void feed(int width, int height) const;

private:
  struct Unit {
    int panel = 0;
    unsigned number = 0;
    GLenum target = GL_TEXTURE_2D;
    GLuint name = 0;
    bool owned = true; ///< not a target's, which outlives this
    bool feedback = false;
    bool enabled = false; ///< glEnable(target): for ATI's shaders, whose text does not say
    const scene::TextureSpec *spec = nullptr; ///< null: no line names it
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
