#pragma once
#include <GL/gl.h>

/// EvalMesh (OpenGL 2.1, 5.1), called by the application or by a display list.
namespace arbiter::state {

struct RasterContext;

/// An EvalMesh command: first and last grid number in u and in v.
struct EvaluatorMesh {
  GLuint dimension;
  GLenum mode;
  GLint u1, u2, v1, v2;

  [[nodiscard]] bool hasMode() const {
    return mode == GL_POINT || mode == GL_LINE || (mode == GL_FILL && dimension == 2);
  }
};

/// Draws the mesh by the layer's evaluators, records it, or leaves it to the host.
void issueEvalMesh(RasterContext &context, const EvaluatorMesh &mesh);

} // namespace arbiter::state
