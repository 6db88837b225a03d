// Symbols of EXT_vertex_shader and their values. Lists hold commands on invariants and variants;
// the others are executed at once.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/lists/list_compiler.h"
#include "state/primitives/recorder.h"
#include "state/programs/program_bind.h"
#include "state/programs/vertex_shaders/bindings.h"
#include "state/programs/vertex_shaders/given_values.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using fp::vertex_shader::DataType;
using fp::vertex_shader::From;

/// Returns the symbol, if GenSymbols made it with that storage type. Otherwise raises an error and
/// returns null.
std::shared_ptr<VertexSymbol> ownSymbol(Context &context, GLuint id, GLenum storage,
                                        const char *why) {
  std::shared_ptr<VertexSymbol> symbol = context.group->vertexSymbols.find(id);
  if (symbol && symbol->isOwn(storage))
    return symbol;
  raise(context, GL_INVALID_VALUE, why);
  return nullptr;
}

From sourceOf(GLenum storage) {
  switch (storage) {
  case GL_VARIANT_EXT:
    return From::Attribute;
  case GL_INVARIANT_EXT:
    return From::Invariant;
  case GL_LOCAL_CONSTANT_EXT:
    return From::Constant;
  default:
    return From::Local;
  }
}

/// Sets a current attribute: of the recorded primitive, else of the host.
void setAttribute(const Context &context, GLuint index, const Vec4 &v) {
  if (context.recorder)
    context.recorder->set(kGeneric0 + int(index), v[0], v[1], v[2], v[3]);
  else
    context.host->VertexAttrib4fv(index, v.data());
}

template <typename T> void setVariant(Context &context, GLuint id, const T *numbers) {
  const auto symbol = ownSymbol(context, id, GL_VARIANT_EXT, "Variant: no variant of that name");
  if (!symbol || !numbers)
    return;
  const std::vector<Vec4> columns = givenColumns(*symbol, numbers);
  for (std::size_t i = 0; i < columns.size(); ++i)
    setAttribute(context, symbol->meaning.attributes[i].index, columns[i]);
}

/// Runs Bind...ParameterEXT. The specification does not allow them inside a definition, but
/// programs of the time use them there.
template <typename Bind> GLuint bound(Context &context, const char *command, Bind bind) {
  return outsideBeginEnd(context, command) ? bind() : 0;
}

} // namespace

namespace handlers {

GLuint GenSymbolsEXT(Context &context, GLenum datatype, GLenum storagetype, GLenum range,
                     GLuint components) {
  if (!outsideBeginEnd(context, "GenSymbols between Begin and End"))
    return 0;
  if (datatype < GL_SCALAR_EXT || datatype > GL_MATRIX_EXT || storagetype < GL_VARIANT_EXT ||
      storagetype > GL_LOCAL_EXT ||
      (range != GL_NORMALIZED_RANGE_EXT && range != GL_FULL_RANGE_EXT)) {
    raise(context, GL_INVALID_ENUM, "GenSymbols: datatype, storagetype or range");
    return 0;
  }
  VertexSymbol kind;
  kind.storage = storagetype;
  kind.normalized = range == GL_NORMALIZED_RANGE_EXT;
  kind.meaning.type = DataType(datatype - GL_SCALAR_EXT);
  kind.meaning.from = sourceOf(storagetype);
  kind.meaning.clampsAttributes = kind.normalized;
  const GLuint first =
      components == 0 ? 0 : context.group->vertexSymbols.generate(kind, components);
  if (first == 0)
    raise(context, GL_INVALID_VALUE, "GenSymbols: components is 0 or more than there can be");
  return first;
}

GLuint BindLightParameterEXT(Context &context, GLenum light, GLenum value) {
  return bound(context, "BindLightParameter between Begin and End",
               [&] { return bindLightParameter(context, light, value); });
}

GLuint BindMaterialParameterEXT(Context &context, GLenum face, GLenum value) {
  return bound(context, "BindMaterialParameter between Begin and End",
               [&] { return bindMaterialParameter(context, face, value); });
}

GLuint BindTexGenParameterEXT(Context &context, GLenum unit, GLenum coord, GLenum value) {
  return bound(context, "BindTexGenParameter between Begin and End",
               [&] { return bindTexGenParameter(context, unit, coord, value); });
}

GLuint BindTextureUnitParameterEXT(Context &context, GLenum unit, GLenum value) {
  return bound(context, "BindTextureUnitParameter between Begin and End",
               [&] { return bindTextureUnitParameter(context, unit, value); });
}

GLuint BindParameterEXT(Context &context, GLenum value) {
  return bound(context, "BindParameter between Begin and End",
               [&] { return bindParameter(context, value); });
}

void SetInvariantEXT(Context &context, GLuint id, GLenum type, const void *addr) {
  if (!outsideBeginEnd(context, "SetInvariant between Begin and End"))
    return;
  if (context.vertexShaders->recorder)
    return raise(context, GL_INVALID_OPERATION, "SetInvariant in the definition of a shader");
  const auto symbol =
      ownSymbol(context, id, GL_INVARIANT_EXT, "SetInvariant: no invariant of that name");
  if (!symbol || !addr)
    return;
  const auto rows = givenRows(*symbol, type, addr);
  if (!rows)
    return raise(context, GL_INVALID_ENUM, "SetInvariant: type");
  if (!context.listMode)
    return setInvariant(context, id, *rows);
  noteProgramApiUse(context);
  listCompiler(context).record(context, {.kind = Command::Kind::Env,
                                         .target = infoOf(Target::VertexShader).name,
                                         .name = id,
                                         .values = *rows});
}

void SetLocalConstantEXT(Context &context, GLuint id, GLenum type, const void *addr) {
  if (!outsideBeginEnd(context, "SetLocalConstant between Begin and End"))
    return;
  if (!context.vertexShaders->recorder)
    return raise(context, GL_INVALID_OPERATION, "SetLocalConstant outside Begin/EndVertexShader");
  const auto symbol = ownSymbol(context, id, GL_LOCAL_CONSTANT_EXT,
                                "SetLocalConstant: no local constant of that name");
  if (!symbol || !addr)
    return;
  const auto rows = givenRows(*symbol, type, addr);
  if (!rows)
    return raise(context, GL_INVALID_ENUM, "SetLocalConstant: type");
  const auto verdict = context.vertexShaders->recorder->setConstant(id);
  if (verdict.error != GL_NO_ERROR)
    return raise(context, verdict.error, verdict.why);
  for (std::size_t row = 0; row < rows->size(); ++row)
    symbol->value[row].store((*rows)[row]);
}

#define VARIANT(letter, T)                                                                         \
  void Variant##letter##vEXT(Context &context, GLuint id, const T *addr) {                         \
    setVariant(context, id, addr);                                                                 \
  }
VARIANT(b, GLbyte)
VARIANT(s, GLshort)
VARIANT(i, GLint)
VARIANT(f, GLfloat)
VARIANT(d, GLdouble)
VARIANT(ub, GLubyte)
VARIANT(us, GLushort)
VARIANT(ui, GLuint)
#undef VARIANT

} // namespace handlers
} // namespace arbiter::state
