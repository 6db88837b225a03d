#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

namespace arbiter::state::imaging {

/// A colour table; without entries it changes nothing.
struct ColorTable {
  GLenum format = GL_RGBA;
  std::vector<Rgba> entries; ///< selected by the format (formats.h)

  /// Puts colours into entries, from `first` on, clamped to 0 to 1 and at the format's precision.
  void set(std::size_t first, const std::vector<Rgba> &colors);
  /// Looks each component of each pixel up (OpenGL 2.1, 3.6.5, Color Table Lookup).
  void apply(Pixels &pixels) const;
};

} // namespace arbiter::state::imaging
