// Queries the vertex arrays of the current vertex array object or of client state.
#include <algorithm>
#include <bit>

#include "state/mirror/attribute_aliases.h"
#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

/// The queries of a conventional array; 0 for a size or type that is fixed.
struct ArrayNames {
  Slot slot;
  GLenum enable, size, type, stride, pointer, buffer;
  std::uint8_t components; ///< used if `size` is 0
  bool normalized;
};
constexpr ArrayNames kNames[] = {
    {kPosition, GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
     GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_BUFFER_BINDING, 4, false},
    {kNormal, GL_NORMAL_ARRAY, 0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE,
     GL_NORMAL_ARRAY_POINTER, GL_NORMAL_ARRAY_BUFFER_BINDING, 3, true},
    {kColor, GL_COLOR_ARRAY, GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE,
     GL_COLOR_ARRAY_POINTER, GL_COLOR_ARRAY_BUFFER_BINDING, 4, true},
    {kSecondary, GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_SIZE,
     GL_SECONDARY_COLOR_ARRAY_TYPE, GL_SECONDARY_COLOR_ARRAY_STRIDE,
     GL_SECONDARY_COLOR_ARRAY_POINTER, GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, 3, true},
    {kFogCoord, GL_FOG_COORD_ARRAY, 0, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_STRIDE,
     GL_FOG_COORD_ARRAY_POINTER, GL_FOG_COORD_ARRAY_BUFFER_BINDING, 1, false},
    {kEdgeFlag, GL_EDGE_FLAG_ARRAY, 0, 0, GL_EDGE_FLAG_ARRAY_STRIDE, GL_EDGE_FLAG_ARRAY_POINTER,
     GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, 1, false},
};
constexpr ArrayNames kTexCoordNames = {kTexCoord0,
                                       GL_TEXTURE_COORD_ARRAY,
                                       GL_TEXTURE_COORD_ARRAY_SIZE,
                                       GL_TEXTURE_COORD_ARRAY_TYPE,
                                       GL_TEXTURE_COORD_ARRAY_STRIDE,
                                       GL_TEXTURE_COORD_ARRAY_POINTER,
                                       GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING,
                                       4,
                                       false};

void setShape(VertexSource::Array &array, GLint size, GLint type, GLint stride) {
  array.bgra = size == GL_BGRA;
  array.components = std::uint8_t(array.bgra ? 4 : size);
  array.type = std::uint32_t(type);
  array.stride = stride != 0 ? std::uint32_t(stride) : elementBytes(array);
}

void add(ArrayBindings &arrays, int slot, const ArrayBinding &binding) {
  arrays.slots[std::size_t(slot)] = binding;
  arrays.enabled |= 1u << slot;
}

void queryArray(const HostQuery &query, const ArrayNames &names, int slot, ArrayBindings &arrays) {
  if (!query.enabled(names.enable))
    return;
  ArrayBinding binding;
  binding.enabled = true;
  binding.array.normalized = names.normalized;
  setShape(binding.array, names.size != 0 ? query.integer(names.size) : names.components,
           names.type != 0 ? query.integer(names.type) : GL_UNSIGNED_BYTE,
           query.integer(names.stride));
  binding.buffer = GLuint(query.integer(names.buffer));
  void *pointer = nullptr;
  query.host.GetPointerv(names.pointer, &pointer);
  binding.array.base = pointer;
  add(arrays, slot, binding);
}

/// Queries where an array in a buffer starts. A binding of ARB_vertex_attrib_binding can be set
/// without the pointer, which then is stale.
void queryBinding(const HostQuery &query, GLuint index, ArrayBinding &binding) {
  GLint point = 0, relative = 0, stride = 0;
  GLint64 offset = 0;
  query.host.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_BINDING, &point);
  query.host.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_RELATIVE_OFFSET, &relative);
  query.host.GetInteger64i_v(GL_VERTEX_BINDING_OFFSET, GLuint(point), &offset);
  query.host.GetIntegeri_v(GL_VERTEX_BINDING_STRIDE, GLuint(point), &stride);
  binding.array.base = reinterpret_cast<const void *>(std::uintptr_t(offset + relative));
  binding.array.stride = std::uint32_t(stride); // 0: all vertices share one element
}

void queryGeneric(const HostCaps &caps, const HostQuery &query, GLuint index,
                  ArrayBindings &arrays) {
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    query.host.GetVertexAttribiv(index, pname, &value);
    return value;
  };
  if (get(GL_VERTEX_ATTRIB_ARRAY_ENABLED) == 0)
    return;
  const int slot = index == 0 ? int(kPosition) : kGeneric0 + int(index);
  ArrayBinding binding;
  binding.enabled = true;
  binding.array.normalized = get(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED) != 0;
  setShape(binding.array, get(GL_VERTEX_ATTRIB_ARRAY_SIZE), get(GL_VERTEX_ATTRIB_ARRAY_TYPE),
           get(GL_VERTEX_ATTRIB_ARRAY_STRIDE));
  binding.buffer = GLuint(get(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING));
  void *pointer = nullptr;
  query.host.GetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
  binding.array.base = pointer;
  if (caps.attribBinding && binding.buffer != 0)
    queryBinding(query, index, binding);
  const bool foreign = (caps.instanced && get(GL_VERTEX_ATTRIB_ARRAY_DIVISOR) != 0) ||
                       (caps.integerArrays && get(GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0) ||
                       (caps.doubleArrays && get(GL_VERTEX_ATTRIB_ARRAY_LONG) != 0) ||
                       binding.array.stride == 0;
  const std::uint32_t bit = 1u << slot;
  arrays.foreign = foreign ? arrays.foreign | bit : arrays.foreign & ~bit;
  add(arrays, slot, binding);
}

void queryTexCoordArrays(const HostCaps &caps, const HostQuery &query, ArrayBindings &arrays) {
  const GLenum first = query.name(GL_CLIENT_ACTIVE_TEXTURE);
  GLenum selected = first;
  const auto select = [&](GLenum unit) {
    if (selected != unit)
      query.host.ClientActiveTexture(selected = unit);
  };
  for (int unit = 0; unit < std::min(caps.maxTextureCoords, 8); ++unit) {
    select(GLenum(GL_TEXTURE0 + unit));
    queryArray(query, kTexCoordNames, kTexCoord0 + unit, arrays);
  }
  select(first);
}

/// Puts generic arrays into the slots of the conventional arrays that they alias.
void addAliases(const AttributeAliases &aliases, ArrayBindings &arrays) {
  const std::uint32_t enabled = arrays.enabled >> kGeneric0;
  for (std::uint32_t left = aliases.arraysUsed & ~aliases.ofProgramsAlone & enabled; left != 0;
       left &= left - 1) {
    const int index = std::countr_zero(left), slot = slotOfRegister(unsigned(index));
    add(arrays, slot, arrays.slots[std::size_t(kGeneric0 + index)]);
    arrays.foreign |= (arrays.foreign >> (kGeneric0 + index) & 1u) << slot;
  }
}

bool restarts(const HostCaps &caps, const HostQuery &query) {
  return (caps.primitiveRestart && query.enabled(GL_PRIMITIVE_RESTART)) ||
         (caps.restartNv && query.enabled(GL_PRIMITIVE_RESTART_NV)) ||
         (caps.fixedIndexRestart && query.enabled(GL_PRIMITIVE_RESTART_FIXED_INDEX));
}

} // namespace

void Mirror::refreshArrays() {
  constexpr std::uint32_t kGroups = dirty::kArrays | dirty::kRaster;
  const std::uint32_t groups = clock.changedSince(arraysSeen) & kGroups;
  arraysSeen = clock.now();
  if (groups == 0) [[likely]]
    return;
  const HostQuery query{m_host};
  arrays.restart = restarts(m_caps, query);
  if ((groups & dirty::kArrays) == 0)
    return;
  arrays.enabled = arrays.foreign = 0;
  for (const ArrayNames &names : kNames)
    queryArray(query, names, names.slot, arrays);
  queryTexCoordArrays(m_caps, query, arrays);
  for (GLuint i = 0; i < GLuint(std::min(m_caps.maxVertexAttribs, 16)); ++i)
    queryGeneric(m_caps, query, i, arrays); // 0 comes after the conventional position and replaces
                                            // it
  if (m_aliases)
    addAliases(*m_aliases, arrays);
  arrays.elementBuffer = GLuint(query.integer(GL_ELEMENT_ARRAY_BUFFER_BINDING));
}

} // namespace arbiter::state
