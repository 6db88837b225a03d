#pragma once
#include <map>

#include "surface.h"

/// A scene of a state test: a background, then a few primitives with a fragment program under the
/// states in a line of run_states.py (factors.py).
namespace software {

inline constexpr int kEdge = 48; ///< of the target, in pixels

class Scene {
public:
  /// Parses "name=number name=number ...".
  explicit Scene(const std::string &line);
  /// Returns a value; aborts if the line lacks the name, as a scene must be complete.
  [[nodiscard]] double number(const std::string &name) const;
  [[nodiscard]] GLenum token(const std::string &name) const { return GLenum(number(name)); }
  [[nodiscard]] int choice(const std::string &name) const { return int(number(name)); }

private:
  std::map<std::string, double> m_values;
};

/// Defines the scene's texture and binds it to unit 0.
void makeSceneTexture(const Scene &scene);
/// Draws depth, color and stencil in zones, by the host's fixed function.
void drawBackground();
void setRasterState(const Scene &scene);
void setPixelState(const Scene &scene);
/// Sets the programs, vertex state and matrices.
void setProgramState(const Scene &scene);
/// Draws a few primitives of the scene's kind; `pass` changes their colors.
void drawPrimitives(const Scene &scene, int pass);

} // namespace software
