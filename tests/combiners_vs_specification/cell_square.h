#pragma once
#include <epoxy/gl.h>

/// Emits the vertices of a grid cell, between Begin and End of QUADS. The grid fills the viewport,
/// row by row from the lower left, with `side` cells in a row.
inline void drawCellSquare(int cell, int side) {
  const float width = 2.0f / float(side);
  const float x = float(cell % side) * width - 1.0f, y = float(cell / side) * width - 1.0f;
  glVertex2f(x, y);
  glVertex2f(x + width, y);
  glVertex2f(x + width, y + width);
  glVertex2f(x, y + width);
}
