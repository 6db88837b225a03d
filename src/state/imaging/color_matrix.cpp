#include "state/imaging/color_matrix.h"

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/core/core_context.h"
#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

namespace {

/// Returns the host's matrix mode that stands in for COLOR.
GLenum borrowed(const CoreContext &context) {
  return GLenum(GL_MATRIX0_ARB + context.caps.maxProgramMatrices - 1);
}

/// Replaces the host's current matrix stack and returns its former contents.
std::vector<imaging::Matrix> replaceStack(const CoreContext &context,
                                          const std::vector<imaging::Matrix> &to) {
  const host::HostTable &host = *context.host;
  std::vector<imaging::Matrix> held(
      std::size_t(hostInteger(*context.host, GL_CURRENT_MATRIX_STACK_DEPTH_ARB)));
  for (std::size_t i = held.size(); i-- > 0;) {
    host.GetFloatv(GL_CURRENT_MATRIX_ARB, held[i].data());
    if (i != 0)
      host.PopMatrix();
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (i != 0)
      host.PushMatrix();
    host.LoadMatrixf(to[i].data());
  }
  return held;
}

void noteMatrices(CoreContext &context) {
  context.dirty |= dirty::kTransform | dirty::kProgramState;
}

} // namespace

bool ColorMatrix::isPossible(const CoreContext &context) {
  return context.caps.maxProgramMatrices > 0 && context.caps.maxProgramMatrixStackDepth >= 2;
}

void ColorMatrix::enter(CoreContext &context) {
  noteUse();
  if (isCurrent(context))
    return;
  context.host->MatrixMode(borrowed(context));
  m_program = replaceStack(context, m_stack);
  m_current = true;
  noteMatrices(context);
}

void ColorMatrix::leave(CoreContext &context) {
  if (!m_current)
    return;
  const GLint mode = hostInteger(*context.host, GL_MATRIX_MODE);
  if (GLenum(mode) != borrowed(context))
    context.host->MatrixMode(borrowed(context));
  m_stack = replaceStack(context, m_program);
  m_current = false;
  if (GLenum(mode) != borrowed(context))
    context.host->MatrixMode(GLenum(mode));
  noteMatrices(context);
}

bool ColorMatrix::isCurrent(CoreContext &context) {
  if (m_current && GLenum(hostInteger(*context.host, GL_MATRIX_MODE)) != borrowed(context))
    leave(context);
  return m_current;
}

void ColorMatrix::restore(CoreContext &context, bool current) {
  if (current) {
    enter(context);
    return;
  }
  // The host has restored its mode, which may be that of the borrowed matrix itself.
  leave(context);
}

imaging::Matrix ColorMatrix::top(CoreContext &context) {
  if (!isCurrent(context))
    return m_stack.back();
  imaging::Matrix matrix;
  context.host->GetFloatv(GL_CURRENT_MATRIX_ARB, matrix.data());
  return matrix;
}

GLint ColorMatrix::depth(CoreContext &context) {
  return isCurrent(context) ? hostInteger(*context.host, GL_CURRENT_MATRIX_STACK_DEPTH_ARB)
                            : GLint(m_stack.size());
}

GLint ColorMatrix::maxDepth(const CoreContext &context) {
  return context.caps.maxProgramMatrixStackDepth;
}

} // namespace arbiter::state
