#include "state/primitives/recorder.h"

#include <algorithm>
#include <cstring>

namespace arbiter::state {

void ImmediateRecorder::begin(GLenum mode, const CurrentValues &current) {
  m_mode = mode;
  m_count = 0;
  m_touched = 0;
  m_failed = false;
  std::copy_n(current.begin(), std::size_t(kMaterial0), m_values.begin());
  m_next = m_data.get();
  m_stride = 4;
  m_slotCount = 1;
  m_slots[0] = kPosition;
  m_given[kPosition] = 0;
  m_starts.clear();
  m_most = kNoLimit;
  setEnd();
}

void ImmediateRecorder::limit(std::uint32_t most, Full full, void *owner) {
  m_most = most;
  m_full = full;
  m_owner = owner;
  setEnd();
}

void ImmediateRecorder::setEnd() {
  const std::size_t most = std::size_t(m_most) * m_stride;
  m_end = m_data.get() + std::min(m_capacity, most);
}

void ImmediateRecorder::forget(std::uint32_t first, std::uint32_t count) {
  float *const to = m_data.get() + first * m_stride;
  std::memmove(to, to + count * m_stride,
               std::size_t(m_count - first - count) * m_stride * sizeof(float));
  m_count -= count;
  m_next = m_data.get() + m_count * m_stride;
  // Slots that were first set at a later vertex keep their meaning under the new numbers.
  for (unsigned i = 1; i < m_slotCount; ++i) {
    std::uint32_t &since = m_since[m_slots[i]];
    since = since > first ? std::max(since, first + count) - count : since;
  }
}

void ImmediateRecorder::forgetEarlier() {
  forget(0, m_starts.back());
  m_starts.clear();
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
  m_capacity = floats;
  setEnd();
  return true;
}

bool ImmediateRecorder::makeRoom(float x, float y, float z, float w) {
  constexpr std::size_t kFirst = 1024;
  if (m_failed)
    return false;
  if (m_count < m_most)
    return reserve(std::max(kFirst, m_capacity * 2));
  const float position[4] = {x, y, z, w};
  return m_full(m_owner, position) && m_next + m_stride <= m_end;
}

void ImmediateRecorder::touch(int slot) {
  m_given[std::size_t(slot)] = 0;
  const std::size_t stride = m_stride + 4;
  if (m_count != 0 && m_count * stride > m_capacity && !reserve(m_count * stride * 2)) {
    m_touched |= SlotMask(1) << slot; // the current value is recorded all the same
    return;
  }
  // Works backwards, because vertices move to higher addresses.
  for (std::size_t i = m_count; i-- > 0;) {
    float *const to = m_data.get() + i * stride;
    std::memmove(to, m_data.get() + i * m_stride, m_stride * sizeof(float));
    std::memcpy(to + m_stride, &m_values[std::size_t(slot)], 4 * sizeof(float));
  }
  m_touched |= SlotMask(1) << slot;
  m_since[slot] = m_count;
  m_slots[m_slotCount++] = std::uint8_t(slot);
  m_stride = stride;
  m_next = m_data.get() + m_count * stride;
  setEnd();
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

} // namespace arbiter::state
