#include "state/software/array_source.h"

#include <algorithm>
#include <bit>

#include "state/context.h"
#include "state/software/ask.h"
#include "state/software/mirror.h"
#include "state/software/vertex_convert.h"

namespace arbiter::state::software {

namespace {

/// Binds buffers to a target for as long as it lives. COPY_READ_BUFFER is no part of any draw.
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

ArraySource::ArraySource(Context &context, const Mirror &mirror, std::uint32_t slots,
                         const DrawCommand &command)
    : m_context(context) {
  m_source.symmetric = context.caps.symmetricSigned;
  m_valid = addArrays(mirror, slots) && addIndices(mirror, command);
}

ArraySource::~ArraySource() {
  if (m_mappedCount == 0)
    return;
  const BufferScope scope(*m_context.host, m_context.caps);
  for (int i = 0; i < m_mappedCount; ++i) {
    m_context.host->BindBuffer(scope.target, m_mapped[std::size_t(i)].buffer);
    m_context.host->UnmapBuffer(scope.target);
  }
}

const ArraySource::Mapped *ArraySource::map(GLuint buffer) {
  for (int i = 0; i < m_mappedCount; ++i)
    if (m_mapped[std::size_t(i)].buffer == buffer)
      return &m_mapped[std::size_t(i)];
  const host::HostTable &host = *m_context.host;
  const BufferScope scope(host, m_context.caps);
  host.BindBuffer(scope.target, buffer);
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetBufferParameteriv(scope.target, pname, &value);
    return value;
  };
  const GLint bytes = get(GL_BUFFER_SIZE); // of 2 GiB and more: the largest integer
  // One that the application has mapped, or whose storage is not to be read, would be an error.
  if (bytes <= 0 || get(GL_BUFFER_MAPPED) != 0)
    return nullptr;
  if (m_context.caps.bufferStorage && get(GL_BUFFER_IMMUTABLE_STORAGE) != 0 &&
      (get(GL_BUFFER_STORAGE_FLAGS) & GL_MAP_READ_BIT) == 0)
    return nullptr;
  const void *const data = host.MapBuffer(scope.target, GL_READ_ONLY);
  if (!data)
    return nullptr;
  Mapped &mapped = m_mapped[std::size_t(m_mappedCount++)];
  mapped = {buffer, static_cast<const std::uint8_t *>(data), std::size_t(bytes)};
  return &mapped;
}

bool ArraySource::addArrays(const Mirror &mirror, std::uint32_t slots) {
  const ArrayBindings &arrays = mirror.arrays;
  if ((arrays.enabled & 1u << kPosition) == 0 || (arrays.foreign & slots) != 0)
    return false;
  for (std::uint32_t left = slots & arrays.enabled; left != 0; left &= left - 1) {
    const auto slot = std::size_t(std::countr_zero(left));
    const ArrayBinding &binding = arrays.slots[slot];
    VertexSource::Array &array = m_source.arrays[slot];
    array = binding.array;
    const std::size_t element = elementBytes(array);
    if (element == 0)
      return false;
    if (binding.buffer != 0) {
      const Mapped *const mapped = map(binding.buffer);
      const auto offset = std::size_t(reinterpret_cast<std::uintptr_t>(array.base));
      if (!mapped || offset > mapped->bytes || element > mapped->bytes - offset)
        return false;
      array.base = mapped->data + offset;
      const std::size_t count = (mapped->bytes - offset - element) / array.stride + 1;
      const auto known = std::uint32_t(std::min(count, std::size_t(UINT32_MAX)));
      m_source.count = m_source.count == 0 ? known : std::min(m_source.count, known);
    }
    if (!array.base)
      return false;
  }
  return true;
}

bool ArraySource::addIndices(const Mirror &mirror, const DrawCommand &command) {
  if (command.indexType == 0)
    return true;
  const std::size_t size = command.indexType == GL_UNSIGNED_BYTE    ? 1
                           : command.indexType == GL_UNSIGNED_SHORT ? 2
                           : command.indexType == GL_UNSIGNED_INT   ? 4
                                                                    : 0;
  if (size == 0 || mirror.arrays.restart || command.count < 0)
    return false;
  m_indices = command.indices;
  if (mirror.arrays.elementBuffer != 0) {
    const Mapped *const mapped = map(mirror.arrays.elementBuffer);
    const auto offset = std::size_t(reinterpret_cast<std::uintptr_t>(command.indices));
    if (!mapped || offset > mapped->bytes ||
        std::size_t(command.count) > (mapped->bytes - offset) / size)
      return false;
    m_indices = mapped->data + offset;
  }
  return m_indices != nullptr;
}

} // namespace arbiter::state::software
