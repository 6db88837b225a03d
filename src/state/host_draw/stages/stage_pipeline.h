#pragma once
#include <GL/gl.h>

namespace arbiter::state {

struct DrawContext;

/// The layer's GLSL that the host draws with. It is one program, or a pipeline that combines a
/// vertex and a fragment program which are not linked together. A context has one such pipeline. It
/// is bound only while no program is current, and never while the application's GLSL shades.
class StagePipeline {
public:
  /// Creates the pipeline on the host. Returns false if the host cannot.
  [[nodiscard]] bool make(DrawContext &context);
  /// Draws with these two programs from now on, and makes no program current. Requires make().
  void use(DrawContext &context, GLuint vertex, GLuint fragment);
  /// Draws with this program alone from now on. Does not make a program current that already is:
  /// some drivers would treat that as a change of state.
  void useAlone(DrawContext &context, GLuint program);
  /// Notes that a list of the host's may have made another program of the layer's current.
  void forgetCurrent() { m_current = 0; }
  /// Unbinds the pipeline.
  void release(DrawContext &context);
  /// True if the layer's pipeline is bound, as far as the layer knows.
  [[nodiscard]] bool isBound() const { return m_isBound; }
  /// Checks whether the application has bound a pipeline of its own instead.
  void lookAgain(DrawContext &context);
  /// Removes a program that is about to be deleted.
  void forget(DrawContext &context, GLuint program);
  [[nodiscard]] bool owns(GLuint pipeline) const { return pipeline != 0 && pipeline == m_name; }

private:
  void setStage(DrawContext &context, GLbitfield stage, GLuint &held, GLuint program);

  GLuint m_name = 0;
  GLuint m_vertex = 0, m_fragment = 0; ///< the pipeline's programs on the host
  bool m_isBound = false;
  GLuint m_current = 0; ///< the layer's current program; 0: not known, or the pipeline is used
};

/// True if the layer's GLSL stages are each linked alone and combined in a pipeline. A host that
/// draws on the processor compiles a fragment program anew for each program it is linked in, which
/// takes longer than loading may. Other hosts may optimize a whole program better.
[[nodiscard]] bool stagesStandApart(const DrawContext &context);

} // namespace arbiter::state
