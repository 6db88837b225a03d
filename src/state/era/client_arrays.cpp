#include "state/era/client_arrays.h"

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/core/core_context.h"

namespace arbiter::state {

namespace {

/// The queries of a conventional array; 0 for a size or type that is fixed.
struct Names {
  GLenum enable, size, type, stride, pointer, buffer;
};
constexpr std::array<Names, ClientArrays::kCount> kNames = {{
    {GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
     GL_VERTEX_ARRAY_POINTER, GL_VERTEX_ARRAY_BUFFER_BINDING},
    {GL_NORMAL_ARRAY, 0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE, GL_NORMAL_ARRAY_POINTER,
     GL_NORMAL_ARRAY_BUFFER_BINDING},
    {GL_COLOR_ARRAY, GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE,
     GL_COLOR_ARRAY_POINTER, GL_COLOR_ARRAY_BUFFER_BINDING},
    {GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_SIZE, GL_SECONDARY_COLOR_ARRAY_TYPE,
     GL_SECONDARY_COLOR_ARRAY_STRIDE, GL_SECONDARY_COLOR_ARRAY_POINTER,
     GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING},
    {GL_FOG_COORD_ARRAY, 0, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_STRIDE,
     GL_FOG_COORD_ARRAY_POINTER, GL_FOG_COORD_ARRAY_BUFFER_BINDING},
    {GL_INDEX_ARRAY, 0, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE, GL_INDEX_ARRAY_POINTER,
     GL_INDEX_ARRAY_BUFFER_BINDING},
    {GL_EDGE_FLAG_ARRAY, 0, 0, GL_EDGE_FLAG_ARRAY_STRIDE, GL_EDGE_FLAG_ARRAY_POINTER,
     GL_EDGE_FLAG_ARRAY_BUFFER_BINDING},
}};
constexpr Names kTexCoord = {GL_TEXTURE_COORD_ARRAY,         GL_TEXTURE_COORD_ARRAY_SIZE,
                             GL_TEXTURE_COORD_ARRAY_TYPE,    GL_TEXTURE_COORD_ARRAY_STRIDE,
                             GL_TEXTURE_COORD_ARRAY_POINTER, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING};

ClientArray read(const host::HostTable &host, const Names &names) {
  ClientArray array;
  array.enabled = host.IsEnabled(names.enable) == GL_TRUE;
  if (names.size != 0)
    array.size = hostInteger(host, names.size);
  if (names.type != 0)
    array.type = hostInteger(host, names.type);
  array.stride = hostInteger(host, names.stride);
  array.buffer = hostInteger(host, names.buffer);
  host.GetPointerv(names.pointer, &array.pointer);
  return array;
}

GenericArray readGeneric(const HostCaps &caps, const host::HostTable &host, GLuint index) {
  const auto get = [&](GLenum name) {
    GLint value = 0;
    host.GetVertexAttribiv(index, name, &value);
    return value;
  };
  GenericArray array;
  array.enabled = get(GL_VERTEX_ATTRIB_ARRAY_ENABLED) != 0;
  array.size = get(GL_VERTEX_ATTRIB_ARRAY_SIZE);
  array.type = get(GL_VERTEX_ATTRIB_ARRAY_TYPE);
  array.stride = get(GL_VERTEX_ATTRIB_ARRAY_STRIDE);
  array.buffer = get(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING);
  host.GetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &array.pointer);
  array.normalized = get(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED) != 0;
  array.integer = caps.integerArrays && get(GL_VERTEX_ATTRIB_ARRAY_INTEGER) != 0;
  array.isLong = caps.doubleArrays && get(GL_VERTEX_ATTRIB_ARRAY_LONG) != 0;
  array.divisor = caps.instanced ? get(GL_VERTEX_ATTRIB_ARRAY_DIVISOR) : 0;
  array.point = caps.attribBinding ? get(GL_VERTEX_ATTRIB_BINDING) : GLint(index);
  array.relative = caps.attribBinding ? get(GL_VERTEX_ATTRIB_RELATIVE_OFFSET) : 0;
  return array;
}

ArrayPoint readPoint(const host::HostTable &host, GLuint index) {
  ArrayPoint point;
  host.GetIntegeri_v(GL_VERTEX_BINDING_BUFFER, index, &point.buffer);
  host.GetInteger64i_v(GL_VERTEX_BINDING_OFFSET, index, &point.offset);
  host.GetIntegeri_v(GL_VERTEX_BINDING_STRIDE, index, &point.stride);
  host.GetIntegeri_v(GL_VERTEX_BINDING_DIVISOR, index, &point.divisor);
  return point;
}

/// Runs `function(set)` for each texture coordinate set, with the set selected.
template <typename F>
void eachTexCoord(const host::HostTable &host, std::size_t count, F function) {
  const GLint selected = hostInteger(host, GL_CLIENT_ACTIVE_TEXTURE);
  for (std::size_t set = 0; set < count; ++set) {
    host.ClientActiveTexture(GLenum(GL_TEXTURE0 + set));
    function(set);
  }
  host.ClientActiveTexture(GLenum(selected));
}

void point(const host::HostTable &host, int which, const ClientArray &to) {
  const auto type = GLenum(to.type);
  switch (which) {
  case ClientArrays::Position:
    return host.VertexPointer(to.size, type, to.stride, to.pointer);
  case ClientArrays::Normal:
    return host.NormalPointer(type, to.stride, to.pointer);
  case ClientArrays::Color:
    return host.ColorPointer(to.size, type, to.stride, to.pointer);
  case ClientArrays::Secondary:
    return host.SecondaryColorPointer(to.size, type, to.stride, to.pointer);
  case ClientArrays::FogCoord:
    return host.FogCoordPointer(type, to.stride, to.pointer);
  case ClientArrays::Index:
    return host.IndexPointer(type, to.stride, to.pointer);
  case ClientArrays::EdgeFlag:
    return host.EdgeFlagPointer(to.stride, to.pointer);
  default:
    return host.TexCoordPointer(to.size, type, to.stride, to.pointer);
  }
}

void write(const host::HostTable &host, int which, GLenum enable, const ClientArray &from,
           const ClientArray &to) {
  if (from == to)
    return;
  host.BindBuffer(GL_ARRAY_BUFFER, GLuint(to.buffer));
  point(host, which, to);
  (to.enabled ? host.EnableClientState : host.DisableClientState)(enable);
}

void setFormat(const host::HostTable &host, GLuint index, const GenericArray &to) {
  const auto type = GLenum(to.type);
  const auto relative = GLuint(to.relative);
  if (to.integer)
    host.VertexAttribIFormat(index, to.size, type, relative);
  else if (to.isLong)
    host.VertexAttribLFormat(index, to.size, type, relative);
  else
    host.VertexAttribFormat(index, to.size, type, to.normalized ? GL_TRUE : GL_FALSE, relative);
}

/// Sets a generic array by its Pointer command, which also sets the binding point of its number.
void pointGeneric(const host::HostTable &host, GLuint index, const GenericArray &to) {
  const auto type = GLenum(to.type);
  host.BindBuffer(GL_ARRAY_BUFFER, GLuint(to.buffer));
  if (to.integer)
    host.VertexAttribIPointer(index, to.size, type, to.stride, to.pointer);
  else if (to.isLong)
    host.VertexAttribLPointer(index, to.size, type, to.stride, to.pointer);
  else
    host.VertexAttribPointer(index, to.size, type, to.normalized ? GL_TRUE : GL_FALSE, to.stride,
                             to.pointer);
}

/// Sets the binding points, and the arrays that use another point than their own. An array in the
/// application's memory needs neither, as only VertexAttribPointer can have set it.
void writePoints(const host::HostTable &host, const ClientArrays &to) {
  for (GLuint i = 0; i < to.points.size() && i < to.generic.size(); ++i) {
    const ArrayPoint &point = to.points[i];
    if (point.buffer != 0)
      host.BindVertexBuffer(i, GLuint(point.buffer), GLintptr(point.offset), point.stride);
    host.VertexBindingDivisor(i, GLuint(point.divisor));
    const GenericArray &array = to.generic[i];
    if (array.point != GLint(i) || array.relative != 0) {
      setFormat(host, i, array);
      host.VertexAttribBinding(i, GLuint(array.point));
    }
  }
}

} // namespace

ClientArrays::ClientArrays(const CoreContext &context)
    : texCoords(std::size_t(context.caps.maxTextureCoords)),
      generic(std::size_t(context.caps.maxVertexAttribs)),
      points(context.caps.attribBinding ? std::size_t(context.caps.maxVertexAttribs) : 0) {
  conventional[Secondary].size = 3;
  for (std::size_t i = 0; i < generic.size(); ++i)
    generic[i].point = GLint(i);
}

ClientArrays readArrays(const CoreContext &context) {
  const host::HostTable &host = *context.host;
  ClientArrays arrays(context);
  for (std::size_t i = 0; i < kNames.size(); ++i)
    arrays.conventional[i] = read(host, kNames[i]);
  eachTexCoord(host, arrays.texCoords.size(),
               [&](std::size_t set) { arrays.texCoords[set] = read(host, kTexCoord); });
  for (GLuint i = 0; i < arrays.generic.size(); ++i)
    arrays.generic[i] = readGeneric(context.caps, host, i);
  for (GLuint i = 0; i < arrays.points.size(); ++i)
    arrays.points[i] = readPoint(host, i);
  arrays.elementBuffer = hostInteger(host, GL_ELEMENT_ARRAY_BUFFER_BINDING);
  return arrays;
}

void writeArrays(const CoreContext &context, const ClientArrays &from, const ClientArrays &to) {
  const host::HostTable &host = *context.host;
  const GLint bound = hostInteger(host, GL_ARRAY_BUFFER_BINDING);
  for (std::size_t i = 0; i < kNames.size(); ++i)
    write(host, int(i), kNames[i].enable, from.conventional[i], to.conventional[i]);
  if (from.texCoords != to.texCoords)
    eachTexCoord(host, to.texCoords.size(), [&](std::size_t set) {
      write(host, ClientArrays::kCount, GL_TEXTURE_COORD_ARRAY, from.texCoords[set],
            to.texCoords[set]);
    });
  const bool pointsDiffer = from.points != to.points;
  for (GLuint i = 0; i < to.generic.size(); ++i) {
    const GenericArray &array = to.generic[i];
    if (!pointsDiffer && from.generic[i] == array)
      continue;
    pointGeneric(host, i, array);
    if (context.caps.instanced && to.points.empty())
      host.VertexAttribDivisor(i, GLuint(array.divisor));
    (array.enabled ? host.EnableVertexAttribArray : host.DisableVertexAttribArray)(i);
  }
  if (pointsDiffer || from.generic != to.generic)
    writePoints(host, to);
  if (from.elementBuffer != to.elementBuffer)
    host.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(to.elementBuffer));
  host.BindBuffer(GL_ARRAY_BUFFER, GLuint(bound));
}

} // namespace arbiter::state
