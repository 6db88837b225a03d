#pragma once
#include <cstdint>

#include "state/core/context_hot.h"
#include "state/lists/known_state.h"

/// Materials between Begin and End (OpenGL 2.1, 2.14.2). Some programs give them with each vertex,
/// and mostly the same ones again: those change nothing, and leave the primitive whole.
namespace arbiter::state::software {

/// What materials were set since the primitive was begun that is recorded.
class PrimitiveMaterials {
public:
  void begin() {
    m_known.forget();
    m_colors = Colors::Unknown;
  }
  void forget() { m_known.forget(); }

private:
  friend bool setsMaterialAgain(ContextHot &hot, GLenum face, GLenum pname, const GLfloat *values);
  /// Whether colours are materials (COLOR_MATERIAL), which no command changes within a primitive.
  enum class Colors : std::uint8_t { Unknown, AreNone, AreMaterials };

  KnownState m_known;
  Colors m_colors = Colors::Unknown;
};

/// Of Material with these values: a primitive is recorded, in which they have been set before and
/// not changed since. Otherwise they are noted. The host may be asked. No error is raised.
[[nodiscard]] bool setsMaterialAgain(ContextHot &hot, GLenum face, GLenum pname,
                                     const GLfloat *values);
/// A material is set by another command.
void forgetMaterials(ContextHot &hot);

} // namespace arbiter::state::software
