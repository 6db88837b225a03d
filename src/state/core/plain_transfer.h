#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

#include "state/core/host_errors.h"

namespace arbiter::state {

class Context;

/// Pixel store and transfer as GL begins with, no pixel buffer bound, alignment 1. AsStored: the
/// transfer alone.
class PlainTransfer {
public:
  enum class Way : std::uint8_t { Pack, Unpack, AsStored };
  PlainTransfer(Context &context, Way way);
  ~PlainTransfer();
  PlainTransfer(const PlainTransfer &) = delete;
  PlainTransfer &operator=(const PlainTransfer &) = delete;

private:
  Context &m_context;
  HostErrorScope m_errors;
  Way m_way;
  std::array<GLint, 8> m_store{};
  GLint m_buffer = 0;
  std::array<GLfloat, 10> m_transfer{};
  GLint m_mapColor = 0;
};

} // namespace arbiter::state
