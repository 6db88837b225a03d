#pragma once
#include <memory>
#include <string>

#include "apps/scene/document.h"
#include "apps/scene/picture.h"
#include "util/result.h"

/// Draws a document with plain GL, so that the layer can be in front, as for any application.
namespace arbiter::tools {

struct RenderError {
  enum class Kind {
    NoGl,    ///< GL is missing, lacks an extension, or reported an error
    Program, ///< GL rejected the text of a file
    Panel,   ///< the setting of a panel is not possible
  };
  Kind kind = Kind::NoGl;
  std::string message;
  std::size_t file = 0; ///< index into Document::files
  int position = -1;    ///< for Program: GL_PROGRAM_ERROR_POSITION_ARB
  fp::Span span = {};   ///< for Panel: the setting; empty if an option set it
};

/// Draws one document into the current framebuffer of the current context, frame by frame. Texture
/// coordinate sets without a panel setting are (s, t, 0, 1), and so is the primary color. A generic
/// attribute without a setting has the value of the conventional attribute in its slot
/// (ARB_vertex_program, table X.1).
class Renderer {
public:
  /// Creates the textures, programs and meshes. \p document must outlive the renderer.
  [[nodiscard]] static Result<std::unique_ptr<Renderer>, RenderError>
  make(const scene::Document &document);
  Renderer(const Renderer &) = delete;
  Renderer &operator=(const Renderer &) = delete;
  ~Renderer();

  /// Draws all passes at the frame's time. With feedback, frames must be drawn in order from 0.
  void draw(int frame);
  [[nodiscard]] scene::Picture read() const;

  /// Draws everything in a frame before a pass, and sets the state of that pass's draw. For
  /// inspecting one draw: the caller continues with clearTarget() if Document::clears(), and with
  /// drawMesh().
  void stopBefore(int frame, std::size_t pass);
  void clearTarget(std::size_t pass) const;
  void drawMesh(std::size_t pass) const;

private:
  struct Parts;
  explicit Renderer(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> m_parts;
};

struct Rendering {
  scene::Picture picture;
  double millisecondsPerFrame = 0; ///< without the first frame, which compiles, if there are more
  std::string renderer;            ///< GL_RENDERER
};

/// Draws frames `first` to `last` on a pbuffer of a display without a window system, and returns
/// the last picture.
[[nodiscard]] Result<Rendering, RenderError> render(const scene::Document &document, int first,
                                                    int last);

} // namespace arbiter::tools
