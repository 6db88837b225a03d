// Variant arrays (EXT_vertex_shader, 2.8) and queries of symbols (6.1.11). The arrays are the
// host's generic ones, so vertex array objects and the client attribute stack hold them.
#include <climits>
#include <cmath>
#include <type_traits>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/client_pixels/client_image.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/mirror/dirty_bits.h"
#include "state/programs/vertex_shaders/bindings.h"
#include "state/programs/vertex_shaders/given_values.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using fp::vertex_shader::DataType;
using fp::vertex_shader::From;

/// Returns the bytes of an array's component; 0 for types that arrays do not have.
GLuint sizeOf(GLenum type) {
  switch (type) {
  case GL_DOUBLE:
    return 8;
  case GL_HALF_FLOAT:
    return 0;
  default:
    return GLuint(componentBytes(type));
  }
}

/// Returns a variant that has arrays. Raises an error and returns null for other names.
std::shared_ptr<VertexSymbol> arrayOf(Context &context, GLuint id, const char *command) {
  if (!outsideBeginEnd(context, command))
    return nullptr;
  std::shared_ptr<VertexSymbol> symbol = context.group->vertexSymbols.find(id);
  if (symbol && symbol->isOwn(GL_VARIANT_EXT))
    return symbol;
  raise(context, GL_INVALID_VALUE, command);
  return nullptr;
}

void setArrayEnabled(Context &context, GLuint id, bool enabled, const char *command) {
  const auto symbol = arrayOf(context, id, command);
  if (!symbol)
    return;
  context.dirty |= dirty::kArrays;
  const auto set =
      enabled ? context.host->EnableVertexAttribArray : context.host->DisableVertexAttribArray;
  for (int column = 0; column < symbol->rows(); ++column)
    set(symbol->meaning.attributes[std::size_t(column)].index);
}

// --- Queries ---

/// Returns a generated or bound symbol of the storage type. Raises an error and returns null if
/// there is none.
std::shared_ptr<VertexSymbol> asked(Context &context, GLuint id, GLenum storage,
                                    const char *command) {
  if (!outsideBeginEnd(context, command))
    return nullptr;
  std::shared_ptr<VertexSymbol> symbol = context.group->vertexSymbols.find(id);
  if (symbol && symbol->storage == storage)
    return symbol;
  raise(context, GL_INVALID_VALUE, command);
  return nullptr;
}

template <typename T> T givenAs(GLfloat value) {
  if constexpr (std::is_same_v<T, GLboolean>)
    return value != 0.0f ? GL_TRUE : GL_FALSE;
  else if constexpr (std::is_integral_v<T>)
    return T(std::lround(value));
  else
    return T(value);
}

/// Returns the columns of the symbol's present value.
std::vector<Vec4> valueOf(Context &context, const VertexSymbol &symbol) {
  std::vector<Vec4> lines(std::size_t(symbol.rows()));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (symbol.bound)
      lines[i] = boundValue(context, symbol, i);
    else if (symbol.storage == GL_VARIANT_EXT)
      context.host->GetVertexAttribfv(symbol.meaning.attributes[i].index, GL_CURRENT_VERTEX_ATTRIB,
                                      lines[i].data());
    else
      lines[i] = symbol.value[i].load();
  }
  return symbol.isOwn(GL_VARIANT_EXT) ? lines : transposed(lines);
}

template <typename T> void giveValue(Context &context, const VertexSymbol &symbol, T *data) {
  const std::size_t each = symbol.type() == DataType::Scalar ? 1 : 4;
  for (const Vec4 &column : valueOf(context, symbol))
    for (std::size_t i = 0; i < each; ++i)
      *data++ = givenAs<T>(column[i]);
}

template <typename T> void giveInteger(GLint value, T *data) {
  if constexpr (std::is_same_v<T, GLboolean>)
    *data = value != 0 ? GL_TRUE : GL_FALSE;
  else
    *data = T(value);
}

GLint arrayValue(const Context &context, const VertexSymbol &symbol, GLenum pname) {
  GLint value = pname == GL_VERTEX_ATTRIB_ARRAY_TYPE ? GLint(GL_FLOAT) : 0;
  if (symbol.isOwn(GL_VARIANT_EXT))
    context.host->GetVertexAttribiv(symbol.meaning.attributes[0].index, pname, &value);
  return value;
}

template <typename T> void getVariant(Context &context, GLuint id, GLenum value, T *data) {
  const auto symbol = asked(context, id, GL_VARIANT_EXT,
                            "GetVariant: no variant of that name, or in Begin and End");
  if (!symbol || !data)
    return;
  switch (value) {
  case GL_VARIANT_VALUE_EXT:
    return giveValue(context, *symbol, data);
  case GL_VARIANT_DATATYPE_EXT:
    return giveInteger(GLint(GL_SCALAR_EXT) + GLint(symbol->type()), data);
  case GL_VARIANT_ARRAY_STRIDE_EXT:
    return giveInteger(arrayValue(context, *symbol, GL_VERTEX_ATTRIB_ARRAY_STRIDE), data);
  case GL_VARIANT_ARRAY_TYPE_EXT:
    return giveInteger(arrayValue(context, *symbol, GL_VERTEX_ATTRIB_ARRAY_TYPE), data);
  default:
    raise(context, GL_INVALID_ENUM, "GetVariant: value");
  }
}

/// Executes GetInvariant and GetLocalConstant.
template <typename T>
void getConstant(Context &context, GLenum storage, GLuint id, GLenum value, T *data) {
  const auto symbol =
      asked(context, id, storage, "a query of a vertex shader's symbol: no such one of that name");
  if (!symbol || !data)
    return;
  const bool invariant = storage == GL_INVARIANT_EXT;
  if (value == (invariant ? GL_INVARIANT_VALUE_EXT : GL_LOCAL_CONSTANT_VALUE_EXT))
    return giveValue(context, *symbol, data);
  if (value == (invariant ? GL_INVARIANT_DATATYPE_EXT : GL_LOCAL_CONSTANT_DATATYPE_EXT))
    return giveInteger(GLint(GL_SCALAR_EXT) + GLint(symbol->type()), data);
  raise(context, GL_INVALID_ENUM, "GetInvariant or GetLocalConstant: value");
}

} // namespace

namespace handlers {

void VariantPointerEXT(Context &context, GLuint id, GLenum type, GLuint stride, const void *addr) {
  const auto symbol = arrayOf(context, id, "VariantPointer: no variant of that name");
  if (!symbol)
    return;
  const GLuint size = sizeOf(type);
  if (size == 0)
    return raise(context, GL_INVALID_ENUM, "VariantPointer: type");
  if (stride > GLuint(INT_MAX))
    return raise(context, GL_INVALID_VALUE, "VariantPointer: stride");
  context.dirty |= dirty::kArrays;
  // An array has four components (2.8); a matrix has four times as many.
  const int columns = symbol->rows();
  const GLuint apart = stride == 0 && columns > 1 ? 16 * size : stride;
  for (int column = 0; column < columns; ++column)
    context.host->VertexAttribPointer(symbol->meaning.attributes[std::size_t(column)].index, 4,
                                      type, symbol->normalized ? GL_TRUE : GL_FALSE, GLsizei(apart),
                                      static_cast<const char *>(addr) +
                                          std::size_t(column) * 4 * size);
}

void EnableVariantClientStateEXT(Context &context, GLuint id) {
  setArrayEnabled(context, id, true, "EnableVariantClientState: no variant of that name");
}

void DisableVariantClientStateEXT(Context &context, GLuint id) {
  setArrayEnabled(context, id, false, "DisableVariantClientState: no variant of that name");
}

GLboolean IsVariantEnabledEXT(Context &context, GLuint id, GLenum cap) {
  const auto symbol = arrayOf(context, id, "IsVariantEnabled: no variant of that name");
  if (!symbol)
    return GL_FALSE;
  if (cap != GL_VARIANT_ARRAY_EXT) {
    raise(context, GL_INVALID_ENUM, "IsVariantEnabled: cap");
    return GL_FALSE;
  }
  return arrayValue(context, *symbol, GL_VERTEX_ATTRIB_ARRAY_ENABLED) != 0 ? GL_TRUE : GL_FALSE;
}

void GetVariantPointervEXT(Context &context, GLuint id, GLenum value, void **data) {
  const auto symbol =
      asked(context, id, GL_VARIANT_EXT, "GetVariantPointer: no variant of that name");
  if (!symbol || !data)
    return;
  if (value != GL_VARIANT_ARRAY_POINTER_EXT)
    return raise(context, GL_INVALID_ENUM, "GetVariantPointer: value");
  *data = nullptr;
  if (symbol->isOwn(GL_VARIANT_EXT))
    context.host->GetVertexAttribPointerv(symbol->meaning.attributes[0].index,
                                          GL_VERTEX_ATTRIB_ARRAY_POINTER, data);
}

#define QUERIES(Type, Pointer)                                                                     \
  void GetVariant##Type##vEXT(Context &context, GLuint id, GLenum value, Pointer data) {           \
    getVariant(context, id, value, data);                                                          \
  }                                                                                                \
  void GetInvariant##Type##vEXT(Context &context, GLuint id, GLenum value, Pointer data) {         \
    getConstant(context, GL_INVARIANT_EXT, id, value, data);                                       \
  }                                                                                                \
  void GetLocalConstant##Type##vEXT(Context &context, GLuint id, GLenum value, Pointer data) {     \
    getConstant(context, GL_LOCAL_CONSTANT_EXT, id, value, data);                                  \
  }
QUERIES(Boolean, GLboolean *)
QUERIES(Integer, GLint *)
QUERIES(Float, GLfloat *)
#undef QUERIES

} // namespace handlers
} // namespace arbiter::state
