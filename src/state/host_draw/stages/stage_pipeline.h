#pragma once
#include <GL/gl.h>

namespace arbiter::state {

class Context;

/// What of the layer's GLSL the host draws with: one program, or the pipeline in which a vertex and
/// a fragment program of the layer's meet that are not linked to each other, each a program of GLSL
/// of one stage. A context has one such pipeline. It is bound only where no program is current, and
/// never while the application's GLSL shades.
class StagePipeline {
public:
  /// The host has a pipeline for the layer; false if it makes none.
  [[nodiscard]] bool make(Context &context);
  /// Draws are by these two programs from now on, and no program is current. Requires make().
  void use(Context &context, GLuint vertex, GLuint fragment);
  /// Draws are by this program alone from now on. The host is not told what it has: to some drivers
  /// a program that is current already is a change of state.
  void useAlone(Context &context, GLuint program);
  /// A list of the host's may have made another program of the layer's current.
  void forgetCurrent() { m_current = 0; }
  /// No pipeline is bound.
  void release(Context &context);
  /// It is what draws, as far as the layer has bound it.
  [[nodiscard]] bool isBound() const { return m_isBound; }
  /// The application may have bound one of its own in its place.
  void lookAgain(Context &context);
  /// The program is about to be deleted.
  void forget(Context &context, GLuint program);
  [[nodiscard]] bool owns(GLuint pipeline) const { return pipeline != 0 && pipeline == m_name; }

private:
  void setStage(Context &context, GLbitfield stage, GLuint &held, GLuint program);

  GLuint m_name = 0;
  GLuint m_vertex = 0, m_fragment = 0; ///< on the host
  bool m_isBound = false;
  GLuint m_current = 0; ///< while the host's program is the layer's; 0: not known, or the pipeline
};

/// Whether the layer's stages of GLSL are linked each alone and meet in a pipeline. A host that
/// draws on the processor compiles a fragment program anew for each program of GLSL that it is
/// linked in, which takes longer than a load may; others may make more of a whole program.
[[nodiscard]] bool stagesStandApart(const Context &context);

} // namespace arbiter::state
