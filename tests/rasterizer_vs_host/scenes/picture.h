#pragma once
#include <string>

#include "surface.h"

namespace software {

/// A kind of primitive, drawn with that many vertices.
struct Kind {
  const char *name;
  GLenum mode;
  int corners;
};

/// A random picture of one kind of primitive, named by its properties.
class PictureByChance {
protected:
  explicit PictureByChance(std::uint64_t seed) : m_random(seed) {}

  float real(float low, float high) { return m_random.real(low, high); }
  /// Returns true in one of two cases, and adds the word to the name.
  bool some(const char *what) {
    const bool is = m_random.once(2);
    m_name += is ? std::string(" ") + what : "";
    return is;
  }
  static void set(GLenum capability, bool on) { (on ? glEnable : glDisable)(capability); }

  Random m_random;
  std::string m_name;
};

/// Calls `draw(seed's name, kind, index of the kind)` for each kind, in a context of its own, and
/// records the errors.
template <typename Kinds, typename Draw>
void drawKinds(int seed, Screen &screen, GLXDrawable window, int edge, const Kinds &kinds,
               Draw draw) {
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(window, context);
  glViewport(0, 0, edge, edge);
  const std::string name = "seed " + std::to_string(seed);
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    draw(name, kinds[i], i);
  record(name + " errors" + takeErrors(), {});
  screen.destroy(context);
}

} // namespace software
