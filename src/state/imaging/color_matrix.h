#pragma once
#include <vector>

#include <GL/gl.h>

#include "state/imaging/arithmetic.h"

namespace arbiter::state {

struct CoreContext;

/// The colour matrix and its stack. The host has no such matrix mode. While COLOR is current, the
/// stack of the host's last program matrix holds it, so that all matrix commands work unchanged.
/// The former contents of that stack are kept here. A program that reads this matrix before another
/// MatrixMode sees the colour matrix.
class ColorMatrix {
public:
  /// True if the host's stack is deep enough for COLOR's least depth
  /// (MAX_COLOR_MATRIX_STACK_DEPTH).
  [[nodiscard]] static bool isPossible(const CoreContext &context);

  /// Executes MatrixMode of COLOR.
  void enter(CoreContext &context);
  /// Ends COLOR, before another MatrixMode of the host's.
  void leave(CoreContext &context);
  /// True if MatrixMode of COLOR was called or recorded once. Any MatrixMode may then end it.
  [[nodiscard]] bool isUsed() const { return m_used; }
  void noteUse() { m_used = true; }
  /// True if COLOR is the matrix mode. A list or PopAttrib may have changed the host's mode.
  [[nodiscard]] bool isCurrent(CoreContext &context);
  /// Restores the mode after PopAttrib.
  /// \param current the push saved COLOR as the mode
  void restore(CoreContext &context, bool current);

  [[nodiscard]] imaging::Matrix top(CoreContext &context);
  [[nodiscard]] GLint depth(CoreContext &context);
  [[nodiscard]] static GLint maxDepth(const CoreContext &context);

private:
  using Stack = std::vector<imaging::Matrix>; ///< bottom first; never empty

  bool m_current = false;
  bool m_used = false;
  Stack m_stack = {imaging::kIdentity}; ///< the colour matrices while another mode is current
  Stack m_program;                      ///< the program matrices while COLOR is current
};

} // namespace arbiter::state
