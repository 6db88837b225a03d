#pragma once
#include <map>

#include "surface.h"

/// One scene of a state test: a background, then a few primitives with a fragment program under the
/// states that a line of run_states.py names (factors.py).
namespace software {

inline constexpr int kEdge = 48; ///< of the target, in pixels

class Scene {
public:
  /// "name=number name=number ...".
  explicit Scene(const std::string &line);
  /// Aborts for a name that the line lacks: a scene is never half a scene.
  [[nodiscard]] double number(const std::string &name) const;
  [[nodiscard]] GLenum token(const std::string &name) const { return GLenum(number(name)); }
  [[nodiscard]] int choice(const std::string &name) const { return int(number(name)); }

private:
  std::map<std::string, double> m_values;
};

/// Defines the texture that the scene names and binds it to unit 0.
void makeSceneTexture(const Scene &scene);
/// Depth, colour and stencil in zones, by the host's fixed function.
void drawBackground();
void setRasterState(const Scene &scene);
void setPixelState(const Scene &scene);
/// The programs, vertices' state and matrices.
void setProgramState(const Scene &scene);
/// A few primitives of the scene's kind; `pass` moves their colours.
void drawPrimitives(const Scene &scene, int pass);

} // namespace software
