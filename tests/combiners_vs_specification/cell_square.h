#pragma once
#include <epoxy/gl.h>

/// Between Begin and End of QUADS: the vertices of a cell of a grid that fills the viewport, row by
/// row from the lower left, `side` cells a row.
inline void drawCellSquare(int cell, int side) {
  const float width = 2.0f / float(side);
  const float x = float(cell % side) * width - 1.0f, y = float(cell / side) * width - 1.0f;
  glVertex2f(x, y);
  glVertex2f(x + width, y);
  glVertex2f(x + width, y + width);
  glVertex2f(x, y + width);
}
