#include "state/raster_draw/vertices/vertex_fetch.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <utility>

#include "swrast/threads.h"

namespace arbiter::state {

namespace {

constexpr std::align_val_t kAlignment{64};
/// Number of vertices in one thread's share.
constexpr std::uint32_t kShare = 16384;

} // namespace

VertexFetcher::Block::Block(Block &&other) noexcept
    : data(std::exchange(other.data, nullptr)), floats(std::exchange(other.floats, 0)) {}

VertexFetcher::Block &VertexFetcher::Block::operator=(Block &&other) noexcept {
  std::swap(data, other.data);
  std::swap(floats, other.floats);
  return *this;
}

VertexFetcher::Block::~Block() { ::operator delete(data, kAlignment); }

bool VertexFetcher::Block::reserve(std::size_t wanted) {
  if (floats >= wanted)
    return true;
  const std::size_t grown = std::max({wanted, floats + floats / 2, std::size_t(256)});
  ::operator delete(std::exchange(data, nullptr), kAlignment);
  floats = 0;
  data = static_cast<float *>(::operator new(grown * sizeof(float), kAlignment, std::nothrow));
  if (!data)
    return false;
  floats = grown;
  std::fill_n(data, floats, 0.0f);
  return true;
}

VertexFetcher::VertexFetcher() = default;
VertexFetcher::~VertexFetcher() = default;

const float *VertexFetcher::constant(Constant &constant, float value) {
  if (constant.block.floats < m_padded) {
    if (!constant.block.reserve(m_padded))
      return nullptr;
    constant.filled = 0;
  }
  // Compares bits, because a NaN differs from itself and -0 equals 0.
  if (std::bit_cast<std::uint32_t>(value) != std::bit_cast<std::uint32_t>(constant.value))
    constant.filled = 0;
  if (constant.filled < m_padded) {
    constant.value = value;
    std::fill(constant.block.data + constant.filled, constant.block.data + m_padded, value);
    constant.filled = m_padded;
  }
  return constant.block.data;
}

bool VertexFetcher::fetchCurrent(const std::array<float, 4> &value, int slot) {
  for (std::size_t c = 0; c < 4; ++c)
    if (!(m_components[std::size_t(slot)][c] = constant(m_current[std::size_t(slot)][c], value[c])))
      return false;
  return true;
}

bool VertexFetcher::openArray(const VertexSource &source, int slot, std::uint32_t first) {
  const VertexSource::Array &array = source.arrays[std::size_t(slot)];
  const Convert conversion = conversionOf(array, source.symmetric);
  if (!conversion)
    return false;
  m_jobs[m_jobCount] = {conversion, {}};
  Conversion &job = m_jobs[m_jobCount++].conversion;
  job.base = static_cast<const std::uint8_t *>(array.base) + std::size_t(first) * array.stride;
  job.stride = array.stride;
  job.count = m_count;
  for (std::size_t c = 0; c < 4; ++c) {
    const float *&component = m_components[std::size_t(slot)][c];
    if (c >= array.components) {
      component = c == 3 ? constant(m_one, 1.0f) : constant(m_zero, 0.0f);
    } else {
      Block &block = m_blocks[std::size_t(slot)][c];
      component = job.to[c] = block.reserve(m_padded) ? block.data : nullptr;
    }
    if (!component)
      return false;
  }
  return true;
}

void VertexFetcher::convert(std::uint32_t begin, std::uint32_t end) const {
  for (unsigned i = 0; i < m_jobCount; ++i) {
    Conversion part = m_jobs[i].conversion;
    part.base += begin * part.stride;
    part.count = end - begin;
    for (float *&to : part.to)
      to = to ? to + begin : nullptr;
    m_jobs[i].convert(part);
  }
}

bool VertexFetcher::fetch(const VertexSource &source, const CurrentValues &current, SlotMask slots,
                          std::uint32_t first, std::uint32_t count) {
  if (!open(source, current, slots, first, count))
    return false;
  const std::uint32_t shares = (count + kShare - 1) / kShare;
  if (shares <= 1) {
    for (unsigned i = 0; i < m_jobCount; ++i)
      m_jobs[i].convert(m_jobs[i].conversion);
    return true;
  }
  auto work = [&](std::uint32_t share) {
    convert(share * kShare, std::min(count, (share + 1) * kShare));
  };
  swrast::parallel(shares, work);
  return true;
}

bool VertexFetcher::open(const VertexSource &source, const CurrentValues &current, SlotMask slots,
                         std::uint32_t first, std::uint32_t count) {
  if (source.count != 0 && (first > source.count || count > source.count - first))
    return false;
  constexpr std::uint32_t kMax = 1u << 28; // keeps indices and sizes within 32 bits
  if (count > kMax)
    return false;
  m_count = count;
  m_jobCount = 0;
  m_padded = (std::max(count, 1u) + 15u) & ~15u;
  for (SlotMask left = slots; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    const bool fetched = source.arrays[std::size_t(slot)].base
                             ? openArray(source, slot, first)
                             : fetchCurrent(current[std::size_t(slot)], slot);
    if (!fetched)
      return false;
  }
  return true;
}

const float *const *VertexFetcher::inputs(std::span<const fp::ir::Attribute> attributes) {
  if (m_inputs.size() < 4 * attributes.size())
    m_inputs.resize(4 * attributes.size());
  const float **to = m_inputs.data();
  for (const fp::ir::Attribute &attribute : attributes) {
    const auto &components = m_components[std::size_t(slotOf(attribute))];
    to = std::copy(components.begin(), components.end(), to);
  }
  return m_inputs.data();
}

float *const *VertexFetcher::outputs(std::size_t count) {
  if (m_outputs.size() >= 4 * count && m_outputFloats >= m_padded) [[likely]]
    return m_outputs.data();
  if (m_outputBlocks.size() < 4 * count)
    m_outputBlocks.resize(4 * count);
  ++m_outputsVersion;
  m_outputFloats = 0;
  m_outputs.clear();
  for (std::size_t i = 0; i < 4 * count; ++i) {
    if (!m_outputBlocks[i].reserve(m_padded))
      return nullptr;
    m_outputs.push_back(m_outputBlocks[i].data);
  }
  m_outputFloats = m_padded;
  return m_outputs.data();
}

const std::uint8_t *VertexFetcher::edgeFlags() {
  const float *const flags = component(kEdgeFlag, 0);
  m_edgeFlags.resize(m_count);
  std::transform(flags, flags + m_count, m_edgeFlags.begin(),
                 [](float flag) { return std::uint8_t(flag != 0.0f ? 1 : 0); });
  return m_edgeFlags.data();
}

namespace {

/// The lowest and the highest index widened so far.
struct Extremes {
  std::uint32_t low = ~0u, high = 0;
  void add(std::uint32_t value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

template <typename T>
void widen(const void *from, std::uint32_t first, std::uint32_t count, std::uint32_t *to,
           Extremes &extremes) {
  const auto *const bytes =
      static_cast<const std::uint8_t *>(from) + std::size_t(first) * sizeof(T);
  Extremes own = extremes;
  for (std::uint32_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, bytes + std::size_t(i) * sizeof(T), sizeof(T));
    to[i] = value;
    own.add(value);
  }
  extremes = own;
}

/// Writes indices [first, first + count) as 32 bits. For type 0, they are the numbers themselves.
bool widen(GLenum type, const void *from, std::uint32_t first, std::uint32_t count,
           std::uint32_t *to, Extremes &extremes) {
  switch (type) {
  case 0:
    for (std::uint32_t i = 0; i < count; ++i)
      to[i] = first + i;
    extremes.add(first);
    extremes.add(first + count - 1);
    return true;
  case GL_UNSIGNED_BYTE:
    widen<std::uint8_t>(from, first, count, to, extremes);
    return true;
  case GL_UNSIGNED_SHORT:
    widen<std::uint16_t>(from, first, count, to, extremes);
    return true;
  case GL_UNSIGNED_INT:
    widen<std::uint32_t>(from, first, count, to, extremes);
    return true;
  default:
    return false;
  }
}

} // namespace

bool boundsOf(GLenum type, const void *indices, std::uint32_t count, IndexBounds &bounds) {
  constexpr std::uint32_t kStep = 4096;
  std::uint32_t block[kStep];
  Extremes extremes;
  for (std::uint32_t first = 0; first < count; first += kStep)
    if (!widen(type, indices, first, std::min(kStep, count - first), block, extremes))
      return false;
  bounds = {extremes.low, extremes.high};
  return true;
}

bool VertexFetcher::reserveIndices(std::uint32_t count) {
  if (m_indexCapacity >= count)
    return true;
  m_indexCapacity = 0;
  m_indices.reset(new (std::nothrow) std::uint32_t[count]);
  if (!m_indices)
    return false;
  m_indexCapacity = count;
  return true;
}

bool VertexFetcher::decodeIndices(GLenum type, const void *indices, std::uint32_t count,
                                  std::int32_t baseVertex, IndexRange &out) {
  out = {};
  return count == 0 || (type != 0 && decodePart(type, indices, {0, count}, baseVertex, out));
}

bool VertexFetcher::decodePart(GLenum type, const void *indices, const SequencePart &part,
                               std::int32_t baseVertex, IndexRange &out) {
  out = {};
  const std::uint32_t lead = part.pivots ? 1 : 0, count = part.count + lead;
  if (!reserveIndices(count))
    return false;
  Extremes extremes;
  if ((part.pivots && !widen(type, indices, part.pivot, 1, m_indices.get(), extremes)) ||
      !widen(type, indices, part.begin, part.count, m_indices.get() + lead, extremes))
    return false;
  const std::int64_t low = std::int64_t(extremes.low) + baseVertex;
  const std::int64_t high = std::int64_t(extremes.high) + baseVertex;
  if (low < 0 || high > std::int64_t(UINT32_MAX))
    return false;
  if (extremes.low != 0)
    for (std::uint32_t i = 0; i < count; ++i)
      m_indices[i] -= extremes.low;
  out = {m_indices.get(), count, std::uint32_t(low), std::uint32_t(high)};
  return true;
}

bool VertexFetcher::isSparse(const IndexRange &range) {
  constexpr std::uint32_t kFew = 1024; // below this, compacting does not pay
  return range.count != 0 && range.maximum - range.minimum >= kFew &&
         (range.maximum - range.minimum) / 2 >= range.count;
}

namespace {

/// Copies scattered vertices together. It handles all arrays of a vertex at once and prefetches,
/// because most of the time is spent waiting for memory.
struct Gather {
  struct Array {
    const std::uint8_t *from;
    std::size_t stride;
    std::uint8_t *to;
    std::size_t bytes; ///< size of one element
  };
  const std::uint32_t *indices = nullptr;
  Array arrays[kSlots];
  std::size_t count = 0;

  void run(std::uint32_t begin, std::uint32_t end) const {
    constexpr std::uint32_t kAhead = 24;
    for (std::uint32_t i = begin; i < end; ++i)
      for (std::size_t a = 0; a < count; ++a) {
        const Array &array = arrays[a];
        if (i + kAhead < end)
          __builtin_prefetch(array.from + std::size_t(indices[i + kAhead]) * array.stride);
        copy(array.to + i * array.bytes, array.from + std::size_t(indices[i]) * array.stride,
             array.bytes);
      }
  }
  static void copy(std::uint8_t *to, const std::uint8_t *from, std::size_t bytes) {
    switch (bytes) { // memcpy of a constant size is no function call
    case 4:
      std::memcpy(to, from, 4);
      return;
    case 8:
      std::memcpy(to, from, 8);
      return;
    case 12:
      std::memcpy(to, from, 12);
      return;
    case 16:
      std::memcpy(to, from, 16);
      return;
    default:
      std::memcpy(to, from, bytes);
    }
  }
};

} // namespace

bool VertexFetcher::compact(VertexSource &source, SlotMask slots, IndexRange &range) {
  if (source.count != 0 && range.maximum >= source.count)
    return false;
  Gather gather;
  gather.indices = range.indices;
  for (SlotMask left = slots; left != 0; left &= left - 1) {
    const auto slot = std::size_t(std::countr_zero(left));
    VertexSource::Array &array = source.arrays[slot];
    const std::size_t bytes = elementBytes(array);
    if (!array.base)
      continue;
    if (bytes == 0 ||
        !m_compacted[slot].reserve((bytes * range.count + sizeof(float) - 1) / sizeof(float)))
      return false;
    auto *const to = reinterpret_cast<std::uint8_t *>(m_compacted[slot].data);
    gather.arrays[gather.count++] = {static_cast<const std::uint8_t *>(array.base) +
                                         std::size_t(range.minimum) * array.stride,
                                     array.stride, to, bytes};
    array.base = to;
    array.stride = std::uint32_t(bytes);
  }
  auto work = [&](std::uint32_t share) {
    gather.run(share * kShare, std::min(range.count, (share + 1) * kShare));
  };
  swrast::parallel((range.count + kShare - 1) / kShare, work);
  for (std::uint32_t i = 0; i < range.count; ++i)
    m_indices[i] = i;
  source.count = range.count;
  range.minimum = 0;
  range.maximum = range.count - 1;
  return true;
}

SlotMask slotsOf(std::span<const fp::ir::Attribute> attributes) {
  SlotMask slots = 0;
  for (const fp::ir::Attribute &attribute : attributes)
    slots |= SlotMask(1) << slotOf(attribute);
  return slots;
}

} // namespace arbiter::state
