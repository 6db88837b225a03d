#include "state/raster_draw/vertices/array_source.h"

#include <algorithm>
#include <bit>

#include "state/mirror/host_query.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/raster_context.h"
#include "state/raster_draw/vertices/vertex_convert.h"

namespace arbiter::state {

namespace {

/// Returns the contents of a buffer that the application keeps mapped while it draws
/// (ARB_buffer_storage). A host that draws on the processor maps the buffer's own memory, so it can
/// be read in place. Data is null if not all of the buffer is mapped so. Requires that the buffer
/// is bound to `target`.
BufferCopies::Contents persistentMapping(const RasterContext &context, GLenum target, GLint bytes) {
  const host::HostTable &host = *context.host;
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetBufferParameteriv(target, pname, &value);
    return value;
  };
  if (!context.caps.bufferStorage || !context.caps.onProcessor ||
      (get(GL_BUFFER_ACCESS_FLAGS) & GL_MAP_PERSISTENT_BIT) == 0 ||
      get(GL_BUFFER_MAP_OFFSET) != 0 || get(GL_BUFFER_MAP_LENGTH) != bytes)
    return {};
  void *data = nullptr;
  host.GetBufferPointerv(target, GL_BUFFER_MAP_POINTER, &data);
  return {static_cast<const std::uint8_t *>(data), data ? std::size_t(bytes) : 0};
}

/// Binds buffers to a target while it lives, and restores the binding. No draw uses
/// COPY_READ_BUFFER.
class BufferScope {
public:
  BufferScope(const host::HostTable &host, const HostCaps &caps)
      : m_host(host), target(caps.copyBuffer ? GL_COPY_READ_BUFFER : GL_ARRAY_BUFFER) {
    m_host.GetIntegerv(caps.copyBuffer ? GL_COPY_READ_BUFFER_BINDING : GL_ARRAY_BUFFER_BINDING,
                       &m_first);
  }
  ~BufferScope() { m_host.BindBuffer(target, GLuint(m_first)); }
  BufferScope(const BufferScope &) = delete;
  BufferScope &operator=(const BufferScope &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_first = 0;

public:
  const GLenum target;
};

} // namespace

bool ArraySource::open(RasterContext &context, const Mirror &mirror, std::uint32_t slots,
                       const DrawCommand &command) {
  m_source.symmetric = context.caps.symmetricSigned;
  const std::uint32_t changed =
      mirror.clock.changedSince(m_seen) & (dirty::kArrays | dirty::kBuffers);
  m_seen = mirror.clock.now();
  if (lacks(mirror, slots, command)) {
    m_kept = false;
    return false;
  }
  if (changed != 0 || !m_kept || slots != m_keptSlots) {
    m_kept = false;
    if (!addArrays(context, mirror, slots))
      return false;
    m_kept = m_mappedCount == 0;
    m_keptSlots = slots;
  }
  return addIndices(context, mirror, command);
}

void ArraySource::close(RasterContext &context) {
  if (m_mappedCount == 0)
    return;
  const BufferScope scope(*context.host, context.caps);
  for (int i = 0; i < m_mappedCount; ++i) {
    if (m_mapped[std::size_t(i)].isApplications)
      continue;
    context.host->BindBuffer(scope.target, m_mapped[std::size_t(i)].buffer);
    context.host->UnmapBuffer(scope.target);
  }
  m_mappedCount = 0;
}

BufferCopies::Contents ArraySource::contentsOf(RasterContext &context, const Mirror &mirror,
                                               GLuint buffer) {
  if (const BufferCopies::Contents copy = m_copies.find(mirror.clock, buffer); copy.data)
    return copy;
  for (int i = 0; i < m_mappedCount; ++i)
    if (m_mapped[std::size_t(i)].buffer == buffer)
      return m_mapped[std::size_t(i)].contents;
  return map(context, buffer);
}

BufferCopies::Contents ArraySource::map(RasterContext &context, GLuint buffer) {
  const host::HostTable &host = *context.host;
  const BufferScope scope(host, context.caps);
  host.BindBuffer(scope.target, buffer);
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetBufferParameteriv(scope.target, pname, &value);
    return value;
  };
  const GLint bytes = get(GL_BUFFER_SIZE); // the largest integer for 2 GiB and more
  // Mapping fails for a buffer that is mapped, or whose storage may not be read.
  if (bytes <= 0)
    return {};
  // mapped by the application: it changes without a command, so it is not copied
  if (get(GL_BUFFER_MAPPED) != 0) {
    const BufferCopies::Contents contents = persistentMapping(context, scope.target, bytes);
    if (contents.data)
      m_mapped[std::size_t(m_mappedCount++)] = {buffer, contents, true};
    return contents;
  }
  if (context.caps.bufferStorage && get(GL_BUFFER_IMMUTABLE_STORAGE) != 0 &&
      (get(GL_BUFFER_STORAGE_FLAGS) & GL_MAP_READ_BIT) == 0)
    return {};
  const void *const data = host.MapBuffer(scope.target, GL_READ_ONLY);
  if (!data)
    return {};
  Mapped &mapped = m_mapped[std::size_t(m_mappedCount++)];
  mapped = {buffer, {static_cast<const std::uint8_t *>(data), std::size_t(bytes)}};
  m_copies.drawnFrom(buffer, mapped.contents);
  return mapped.contents;
}

bool ArraySource::lacks(const Mirror &mirror, std::uint32_t slots, const DrawCommand &command) {
  const ArrayBindings &arrays = mirror.arrays;
  return (arrays.enabled & 1u << kPosition) == 0 || (arrays.foreign & slots) != 0 ||
         (command.indexType != 0 && arrays.restart);
}

bool ArraySource::addArrays(RasterContext &context, const Mirror &mirror, std::uint32_t slots) {
  for (std::uint32_t left = m_slots; left != 0; left &= left - 1)
    m_source.arrays[std::size_t(std::countr_zero(left))] = {};
  m_slots = 0;
  m_source.count = 0;
  const ArrayBindings &arrays = mirror.arrays;
  for (std::uint32_t left = slots & arrays.enabled; left != 0; left &= left - 1) {
    const auto slot = std::size_t(std::countr_zero(left));
    const ArrayBinding &binding = arrays.slots[slot];
    VertexSource::Array &array = m_source.arrays[slot];
    array = binding.array;
    m_slots |= 1u << slot;
    const std::size_t element = elementBytes(array);
    if (element == 0)
      return false;
    if (binding.buffer != 0) {
      const BufferCopies::Contents contents = contentsOf(context, mirror, binding.buffer);
      const auto offset = std::size_t(reinterpret_cast<std::uintptr_t>(array.base));
      if (!contents.data || offset > contents.bytes || element > contents.bytes - offset)
        return false;
      array.base = contents.data + offset;
      const std::size_t count = (contents.bytes - offset - element) / array.stride + 1;
      const auto known = std::uint32_t(std::min(count, std::size_t(UINT32_MAX)));
      m_source.count = m_source.count == 0 ? known : std::min(m_source.count, known);
    }
    if (!array.base)
      return false;
  }
  return true;
}

bool ArraySource::addIndices(RasterContext &context, const Mirror &mirror,
                             const DrawCommand &command) {
  m_indices = nullptr;
  if (command.indexType == 0)
    return true;
  const std::size_t size = command.indexType == GL_UNSIGNED_BYTE    ? 1
                           : command.indexType == GL_UNSIGNED_SHORT ? 2
                           : command.indexType == GL_UNSIGNED_INT   ? 4
                                                                    : 0;
  if (size == 0 || command.count < 0)
    return false;
  m_indices = command.indices;
  if (mirror.arrays.elementBuffer != 0) {
    const BufferCopies::Contents contents =
        contentsOf(context, mirror, mirror.arrays.elementBuffer);
    const auto offset = std::size_t(reinterpret_cast<std::uintptr_t>(command.indices));
    if (!contents.data || offset > contents.bytes ||
        std::size_t(command.count) > (contents.bytes - offset) / size)
      return false;
    m_indices = contents.data + offset;
  }
  return m_indices != nullptr;
}

} // namespace arbiter::state
