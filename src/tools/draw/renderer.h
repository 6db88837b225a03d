#pragma once
#include <memory>
#include <string>

#include "scene/document.h"
#include "scene/picture.h"
#include "util/result.h"

/// Draws with plain GL: `arbiter draw` is a client of the layer like any other.
namespace arbiter::tools {

struct RenderError {
  enum class Kind {
    NoGl,    ///< GL cannot: none, no extension, an error
    Program, ///< GL refuses the text of a file
    Panel,   ///< what a panel asks for cannot be
  };
  Kind kind = Kind::NoGl;
  std::string message;
  std::size_t file = 0; ///< of Document::files
  int position = -1;    ///< Program: GL_PROGRAM_ERROR_POSITION_ARB
  fp::Span span = {};   ///< Panel: empty for what an option asked for
};

/// Draws one document into the current framebuffer of the current context, frame by frame. Every
/// texture coordinate set that a panel says nothing of is (s, t, 0, 1), the primary colour
/// likewise; each generic attribute has the value of the conventional one whose slot it has
/// (ARB_vertex_program, table X.1), where the panel gives it no other.
class Renderer {
public:
  /// Makes its textures, programs and meshes. \p document must live as long as the renderer.
  [[nodiscard]] static Result<std::unique_ptr<Renderer>, RenderError>
  make(const scene::Document &document);
  Renderer(const Renderer &) = delete;
  Renderer &operator=(const Renderer &) = delete;
  ~Renderer();

  /// Draws all passes as they are at the frame's time. With feedback frames come in order from 0.
  void draw(int frame);
  [[nodiscard]] scene::Picture read() const;

  /// For what looks into one draw: draws what comes before a pass of a frame, and leaves the state
  /// as the pass's draw finds it, which is clearTarget() where Document::clears(), and drawMesh().
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
  double millisecondsPerFrame = 0; ///< the first frame, which compiles, is left out if it can be
  std::string renderer;            ///< GL_RENDERER
};

/// On a pbuffer of a display without a window system: frames first to last, the last one's picture.
[[nodiscard]] Result<Rendering, RenderError> render(const scene::Document &document, int first,
                                                    int last);

} // namespace arbiter::tools
