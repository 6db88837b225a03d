#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

namespace arbiter::state::imaging {

/// A colour table. It changes nothing if it is empty.
struct ColorTable {
  GLenum format = GL_RGBA;
  std::vector<Rgba> entries; ///< components that the format has (formats.h)

  /// Sets entries from `first` on, clamped to 0 to 1 and rounded to the format's precision.
  void set(std::size_t first, const std::vector<Rgba> &colors);
  /// Looks up each component of each pixel (OpenGL 2.1, 3.6.5, Color Table Lookup).
  void apply(Pixels &pixels) const;
};

} // namespace arbiter::state::imaging
