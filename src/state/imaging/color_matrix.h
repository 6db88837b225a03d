#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/imaging/arithmetic.h"

namespace arbiter::state {

class Context;

/// The colour matrix and its stack. The host has no such matrix mode: while it is the current one,
/// the stack of the host's last program matrix holds it, so that all commands of matrices work as
/// they are, and what that stack held is kept here. A program that reads this matrix between
/// MatrixMode of COLOR and of another mode would see the colour matrix.
class ColorMatrix {
public:
  /// The host's stack is long enough for the least that COLOR has (MAX_COLOR_MATRIX_STACK_DEPTH).
  [[nodiscard]] static bool isPossible(const Context &context);

  /// MatrixMode of COLOR.
  void enter(Context &context);
  /// MatrixMode of any other: before the host's.
  void leave(Context &context);
  /// MatrixMode of COLOR was called here, maybe into a list: any MatrixMode may end it.
  [[nodiscard]] bool isUsed() const { return m_used; }
  void noteUse() { m_used = true; }
  /// COLOR is the matrix mode. The host's may have been changed by a list or by PopAttrib.
  [[nodiscard]] bool isCurrent(Context &context);
  /// After PopAttrib, whose push saw COLOR as the mode or another.
  void restore(Context &context, bool current);

  [[nodiscard]] imaging::Matrix top(Context &context);
  [[nodiscard]] GLint depth(Context &context);
  [[nodiscard]] static GLint maxDepth(const Context &context);

private:
  using Stack = std::vector<imaging::Matrix>; ///< from the bottom; never empty

  bool m_current = false;
  bool m_used = false;
  Stack m_stack = {imaging::kIdentity}; ///< while another mode is current
  Stack m_program;                      ///< the program matrix's, while COLOR is
};

} // namespace arbiter::state
