#pragma once
#include <array>

#include <GL/gl.h>

#include "state/client_pixels/client_image.h"
#include "state/core/host_errors.h"

namespace arbiter::state {

/// Sets pixel transfer to GL's initial state, which leaves pixels unchanged, and restores it at the
/// end. Errors of host calls within the scope are dropped.
class PlainArithmetic {
public:
  explicit PlainArithmetic(CoreContext &context);
  ~PlainArithmetic();
  PlainArithmetic(const PlainArithmetic &) = delete;
  PlainArithmetic &operator=(const PlainArithmetic &) = delete;

private:
  CoreContext &m_context;
  HostErrorScope m_errors;
  std::array<GLfloat, 10> m_transfer{};
  GLint m_mapColor = 0;
};

/// Sets pixel transfer and the pixel store to GL's initial state, with alignment 1 and no pixel
/// buffer bound, and restores them at the end.
class PlainTransfer {
public:
  PlainTransfer(CoreContext &context, PixelStore way);
  ~PlainTransfer();
  PlainTransfer(const PlainTransfer &) = delete;
  PlainTransfer &operator=(const PlainTransfer &) = delete;

private:
  CoreContext &m_context;
  PlainArithmetic m_arithmetic;
  PixelStore m_way;
  std::array<GLint, 8> m_store{};
  GLint m_buffer = 0;
};

} // namespace arbiter::state
