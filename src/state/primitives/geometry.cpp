#include "state/primitives/geometry.h"

#include <algorithm>
#include <bit>

#include "state/primitives/joined.h"

namespace arbiter::state {

std::uint32_t independentVertices(GLenum mode) {
  switch (mode) {
  case GL_POINTS:
    return 1;
  case GL_LINES:
    return 2;
  case GL_TRIANGLES:
    return 3;
  case GL_QUADS:
    return 4;
  default:
    return 0;
  }
}

namespace {

bool isUniform(const ImmediateRecorder &recorder) {
  for (unsigned i = 1; i < recorder.slotCount(); ++i)
    if (recorder.since(int(recorder.slot(i))) != 0)
      return false;
  return true;
}

void take(Geometry &to, const ImmediateRecorder &recorder) {
  for (unsigned i = 0; i < recorder.slotCount(); ++i)
    to.given[recorder.slot(i)] |= recorder.given()[recorder.slot(i)];
  if (to.fromArrays)
    return;
  to.touched |= recorder.touched();
  for (SlotMask left = recorder.touched(); left != 0; left &= left - 1) {
    const auto slot = std::size_t(std::countr_zero(left));
    to.values[slot] = recorder.values()[slot];
  }
}

/// True if a value was set after the last vertex. Requires that take() was called with the last
/// vertices of `geometry`.
bool endsOtherwise(const Geometry &geometry) {
  if (geometry.count == 0)
    return geometry.touched != 0;
  const float *const last = geometry.data.data() + geometry.data.size() - geometry.stride;
  for (unsigned i = 1; i < geometry.slotCount; ++i)
    if (const auto &value = geometry.values[geometry.slots[i]];
        !std::equal(value.begin(), value.end(), last + 4 * i))
      return true;
  return false;
}

VertexSource sourceOf(const Geometry &geometry, const float *data) {
  VertexSource source;
  source.count = geometry.count;
  source.fromList = true;
  for (unsigned i = 0; i < geometry.slotCount; ++i)
    source.arrays[geometry.slots[i]] = {.base = data + 4 * i,
                                        .stride = std::uint32_t(geometry.stride * sizeof(float)),
                                        .type = GL_FLOAT,
                                        .components = 4};
  return source;
}

} // namespace

std::unique_ptr<Geometry> geometryOf(const ImmediateRecorder &recorder, bool fromArrays) {
  auto geometry = std::make_unique<Geometry>();
  geometry->fromArrays = fromArrays;
  geometry->mode = recorder.mode();
  geometry->count = recorder.count();
  geometry->slotCount = recorder.slotCount();
  geometry->stride = 4 * geometry->slotCount;
  for (unsigned i = 0; i < recorder.slotCount(); ++i) {
    geometry->slots[i] = recorder.slot(i);
    geometry->since[i] = recorder.since(int(recorder.slot(i)));
  }
  geometry->uniform = isUniform(recorder);
  geometry->data.assign(recorder.data(),
                        recorder.data() + std::size_t(geometry->count) * geometry->stride);
  take(*geometry, recorder);
  geometry->endsOtherwise = !fromArrays && endsOtherwise(*geometry);
  return geometry;
}

namespace {

/// Most vertices in one draw of primitives that are joined by indices.
constexpr std::uint32_t kMaxJoined = 1u << 16;

/// Returns the number of vertices without those of an incomplete last primitive, which is not
/// drawn.
std::uint32_t wholeVertices(const Geometry &geometry, std::uint32_t size) {
  return size == 0 ? geometry.count : geometry.count - geometry.count % size;
}

bool isDrawnAlike(const Geometry &to, const ImmediateRecorder &recorder, bool fromArrays) {
  // Slots are in the order of their first use.
  return recorder.mode() == to.mode && fromArrays == to.fromArrays && to.uniform &&
         isUniform(recorder) && recorder.slotCount() == to.slotCount &&
         std::equal(to.slots.begin(), to.slots.begin() + to.slotCount, recorder.slots());
}

/// Reserves room for `more` elements, so that adding them cannot fail.
template <typename T> void makeRoom(std::vector<T> &elements, std::size_t more) {
  if (elements.capacity() - elements.size() < more)
    elements.reserve(std::max(elements.size() + more, 2 * elements.capacity()));
}

/// Joins the recorder's vertices, which have been appended to `to` from `first` on, as another
/// primitive.
void join(Geometry &to, std::uint32_t first) {
  if (to.starts.empty())
    appendIndices(to.indices, to.mode, 0, first);
  to.starts.push_back(first);
  appendIndices(to.indices, to.mode, first, to.count - first);
}

} // namespace

bool append(Geometry &to, const ImmediateRecorder &recorder, bool fromArrays) {
  const std::uint32_t size = independentVertices(to.mode);
  const std::uint32_t most = size == 0 ? kMaxJoined : 1u << 24;
  if (!isDrawnAlike(to, recorder, fromArrays) || to.open || to.count == 0 ||
      recorder.count() == 0 || to.count + recorder.count() > most)
    return false;
  const std::uint32_t whole = wholeVertices(to, size);
  // Memory is reserved before anything changes, because this may fail.
  makeRoom(to.data, std::size_t(recorder.count()) * to.stride);
  if (size == 0) {
    constexpr std::size_t kIndices = 3; // most indices for each vertex
    makeRoom(to.starts, 1);
    makeRoom(to.indices, kIndices * ((to.starts.empty() ? whole : 0) + recorder.count()));
  }
  to.data.resize(std::size_t(whole) * to.stride);
  to.data.insert(to.data.end(), recorder.data(),
                 recorder.data() + std::size_t(recorder.count()) * to.stride);
  to.count = whole + recorder.count();
  if (size == 0)
    join(to, whole);
  take(to, recorder);
  to.endsOtherwise = !fromArrays && endsOtherwise(to);
  return true;
}

VertexSource Geometry::source() const { return sourceOf(*this, data.data()); }

VertexSource Geometry::source(const CurrentValues &current, std::vector<float> &store) const {
  store = data;
  for (unsigned i = 1; i < slotCount; ++i)
    for (std::uint32_t vertex = 0; vertex < std::min(since[i], count); ++vertex)
      std::copy_n(current[slots[i]].data(), 4, store.data() + std::size_t(vertex) * stride + 4 * i);
  return sourceOf(*this, store.data());
}

std::uint32_t Geometry::unsetSlots() const {
  std::uint32_t bits = 0;
  for (unsigned i = 1; i < slotCount; ++i)
    if (since[i] != 0)
      bits |= 1u << slots[i];
  return bits;
}

GLuint Geometry::madeHostList() const {
  const std::lock_guard lock(m_mutex);
  return m_hostList;
}

} // namespace arbiter::state
