#pragma once
#include <string>

#include "tools/draw/scene.h"

/// Draws with plain GL: `arbiter draw` is a client of the layer like any other.
namespace arbiter::tools {

struct Rendering {
  Picture picture;
  double millisecondsPerFrame = 0; ///< the first frame, which compiles, is left out if it can be
  std::string renderer;            ///< GL_RENDERER
};

struct RenderError {
  enum class Kind { NoGl, Program, Scene } kind = Kind::NoGl;
  std::string message;
  int position = -1;       ///< Program: GL_PROGRAM_ERROR_POSITION_ARB
  std::size_t program = 0; ///< Program: of Scene::programs
};

/// Draws on a pbuffer of a display without a window system. The modelview matrix is the identity,
/// the projection glOrtho(-1, 1, -1, 1, -1, 1). Every texture coordinate set is (s, t, 0, 1), the
/// primary colour likewise; each generic attribute has the value of the conventional one whose slot
/// it has (ARB_vertex_program, table X.1), where the scene gives it no other.
[[nodiscard]] Result<Rendering, RenderError> render(const Scene &scene);

} // namespace arbiter::tools
