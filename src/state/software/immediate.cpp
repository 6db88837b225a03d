#include "state/software/immediate.h"

#include <cstring>

namespace arbiter::state::software {

void ImmediateRecorder::begin(GLenum mode, const CurrentValues &current) {
  m_mode = mode;
  m_count = 0;
  m_touched = 0;
  m_failed = false;
  m_values = current;
  m_next = m_data.get();
  m_stride = 4;
  m_slotCount = 1;
  m_slots[0] = kPosition;
}

bool ImmediateRecorder::reserve(std::size_t floats) {
  const std::size_t used = std::size_t(m_next - m_data.get());
  auto *const larger = static_cast<float *>(std::realloc(m_data.get(), floats * sizeof(float)));
  if (!larger) {
    m_failed = true;
    return false;
  }
  (void)m_data.release();
  m_data.reset(larger);
  m_next = larger + used;
  m_end = larger + floats;
  return true;
}

bool ImmediateRecorder::grow() {
  constexpr std::size_t kFirst = 1024;
  const std::size_t floats = std::size_t(m_end - m_data.get());
  return !m_failed && reserve(floats < kFirst ? kFirst : floats * 2);
}

void ImmediateRecorder::touch(int slot) {
  const std::size_t stride = m_stride + 4;
  if (m_count != 0 && m_data.get() + m_count * stride > m_end && !reserve(m_count * stride * 2)) {
    m_touched |= 1u << slot; // the current value is set all the same
    return;
  }
  // From the last one on, as the places of the later ones lie behind those of the earlier.
  for (std::size_t i = m_count; i-- > 0;) {
    float *const to = m_data.get() + i * stride;
    std::memmove(to, m_data.get() + i * m_stride, m_stride * sizeof(float));
    std::memcpy(to + m_stride, &m_values[std::size_t(slot)], 4 * sizeof(float));
  }
  m_touched |= 1u << slot;
  m_since[slot] = m_count;
  m_slots[m_slotCount++] = std::uint8_t(slot);
  m_stride = stride;
  m_next = m_data.get() + m_count * stride;
}

VertexSource ImmediateRecorder::end() const {
  VertexSource source;
  source.count = m_count;
  for (unsigned i = 0; i < m_slotCount; ++i)
    source.arrays[m_slots[i]] = {.base = m_data.get() + 4 * i,
                                 .stride = std::uint32_t(m_stride * sizeof(float)),
                                 .type = GL_FLOAT,
                                 .components = 4};
  return source;
}

} // namespace arbiter::state::software
