#pragma once
#include <array>

#include <GL/gl.h>

#include "state/client_pixels/client_image.h"
#include "state/core/host_errors.h"

namespace arbiter::state {

/// Pixel transfer as GL begins with: nothing is scaled, moved or mapped. Errors of host calls
/// within are dropped.
class PlainArithmetic {
public:
  explicit PlainArithmetic(Context &context);
  ~PlainArithmetic();
  PlainArithmetic(const PlainArithmetic &) = delete;
  PlainArithmetic &operator=(const PlainArithmetic &) = delete;

private:
  Context &m_context;
  HostErrorScope m_errors;
  std::array<GLfloat, 10> m_transfer{};
  GLint m_mapColor = 0;
};

/// The same, and the pixel store as GL begins with but for alignment 1, no pixel buffer bound.
class PlainTransfer {
public:
  PlainTransfer(Context &context, PixelStore way);
  ~PlainTransfer();
  PlainTransfer(const PlainTransfer &) = delete;
  PlainTransfer &operator=(const PlainTransfer &) = delete;

private:
  Context &m_context;
  PlainArithmetic m_arithmetic;
  PixelStore m_way;
  std::array<GLint, 8> m_store{};
  GLint m_buffer = 0;
};

} // namespace arbiter::state
