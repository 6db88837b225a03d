#pragma once
#include "state/core/context_hot.h"
#include "state/mirror/attributes.h"
#include "state/raster_draw/outcome.h"

/// Materials between Begin and End (OpenGL 2.1, 2.14.2). Some programs give them with each vertex,
/// and mostly the same ones again. What changes nothing is left out; parts that change are recorded
/// as attributes are, in slots of their own, and those that differ from vertex to vertex are
/// attributes of fixed function's vertices (fixed_function/). Programs of the application's that
/// read materials take those of before the primitive, which is split for them (split.h).
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

/// Of the primitives that are recorded, each part by its bit.
class PrimitiveMaterials {
public:
  /// What the next ones are chosen for, until it is known what differs: as the last ones.
  [[nodiscard]] MaterialMask chosen() const { return m_chosen; }
  void forgetChosen() { m_chosen = 0; }
  void begin() {
    m_known = m_differing = m_given = 0;
    m_isUndecided = false;
  }

private:
  friend bool recordsMaterial(ContextHot &hot, GLenum face, GLenum pname, const GLfloat *values);
  friend Outcome readyMaterials(Context &context);
  friend SlotMask slotsToSet(const Context &context);

  MaterialMask m_known = 0;     ///< the recorder has their values
  MaterialMask m_differing = 0; ///< not the same for all vertices
  MaterialMask m_given = 0;     ///< the host has those of the recorder
  MaterialMask m_chosen = 0;    ///< differing ones that the draw was chosen for
  bool m_isUndecided = false;   ///< that came to nothing, and may come to something yet
};

/// Of Material with these values: true where it is part of a primitive that is recorded now, or
/// changes nothing of it. The host may be asked. No error is raised.
[[nodiscard]] bool recordsMaterial(ContextHot &hot, GLenum face, GLenum pname,
                                   const GLfloat *values);

/// Before recorded vertices are drawn: those that have a material in common have it of the host,
/// and functions are chosen for the others. Not ok: the host draws. Requires: no primitive is open.
Outcome readyMaterials(Context &context);
/// Slots whose values the host is to have behind the primitive (ImmediateRecorder::touched()), but
/// for those that it has.
[[nodiscard]] SlotMask slotsToSet(const Context &context);

} // namespace arbiter::state::software
