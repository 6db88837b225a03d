// Commands that set TEXTURE_COMPARE_MODE or DEPTH_TEXTURE_MODE, of a texture or a sampler. After
// the first one, draws of programs with plain targets look for textures that compare, and draws
// beside clip distances for ALPHA depths (state/programs/variants/alpha_depths.h). A list's
// commands are noted when they are compiled. PopAttrib restores only what such a command has set.
#include <string>
#include <type_traits>
#include <utility>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/era/sgix_shadow.h"
#include "state/era/texture_range.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/lists/list_compiler.h"
#include "state/lists/texture_commands.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

[[gnu::noinline, gnu::cold]] void use(Context &context, std::atomic<bool> &used) {
  if (!used.exchange(true, std::memory_order_relaxed))
    context.attention |= attention::kProgram;
}

template <typename T> void note(Context &context, GLenum pname, T value) {
  if (pname == GL_TEXTURE_COMPARE_MODE && value != T(GL_NONE)) [[unlikely]]
    use(context, context.group->compareModeUsed);
  if (pname == GL_DEPTH_TEXTURE_MODE && value == T(GL_ALPHA)) [[unlikely]]
    use(context, context.group->alphaDepthsUsed);
}
template <typename T> void note(Context &context, GLenum pname, const T *values) {
  if ((pname == GL_TEXTURE_COMPARE_MODE || pname == GL_DEPTH_TEXTURE_MODE) && values) [[unlikely]]
    note(context, pname, *values);
}

// Sets one of SGIX_shadow's two parameters of the bound texture, which are ARB_shadow's by other
// names (state/era/sgix_shadow.h). The extension is older than commands that name an object.
template <typename T> void setShadow(Context &context, GLenum target, GLenum pname, T value) {
  const ShadowParameter parameter = arbShadow(pname, GLint(value));
  if (!parameter.valid)
    return raise(context, GL_INVALID_OPERATION, "TexParameter: TEXTURE_COMPARE_OPERATOR_SGIX");
  note(context, parameter.pname, parameter.value);
  context.host->TexParameteri(target, parameter.pname, parameter.value);
  noteTextureCommand(context);
}
template <typename T>
void setShadow(Context &context, GLenum target, GLenum pname, const T *value) {
  if (value)
    setShadow(context, target, pname, *value);
}

void issueRange(Context &context, Command command) {
  if (!outsideBeginEnd(context, "a texture's range between Begin and End"))
    return;
  if (!context.listMode)
    return executeTextureRange(context, command);
  noteProgramApiUse(context);
  listCompiler(context).record(context, std::move(command));
}

/// Executes TexParameter of APPLE_texture_range for the bound texture.
template <typename T> void setRange(Context &context, GLenum target, GLenum pname, T value) {
  const bool isName = double(value) >= 0.0 && double(value) < 65536.0;
  issueRange(context, {.kind = Command::Kind::TextureRange,
                       .target = target,
                       .name = pname,
                       .format = isName ? GLenum(value) : 0});
}
template <typename T> void setRange(Context &context, GLenum target, GLenum pname, const T *value) {
  if (value)
    setRange(context, target, pname, *value);
}

template <typename T> void getRange(Context &context, GLenum target, GLenum pname, T *value) {
  TextureRange range;
  if (outsideBeginEnd(context, "GetTexParameter between Begin and End") &&
      getTextureRange(context, target, range) && value)
    *value = pname == GL_TEXTURE_RANGE_LENGTH_APPLE ? T(range.length) : T(GLint(range.storageHint));
}

/// Returns the host's name of a parameter. TEXTURE_BORDER_VALUES_NV is the host's border colour,
/// which it does not clamp. It has four values, so commands with one value are not affected.
GLenum hostName(const Context &context, GLenum pname) {
  return pname == GL_TEXTURE_BORDER_VALUES_NV && hasTextureShaders(context)
             ? GLenum(GL_TEXTURE_BORDER_COLOR)
             : pname;
}
template <typename T> GLenum hostName(const Context &context, GLenum pname, T) {
  return std::is_pointer_v<T> ? hostName(context, pname) : pname;
}

} // namespace

namespace handlers {

#define BOUND_GETTER(name, Pointer)                                                                \
  void name(Context &context, GLenum target, GLenum pname, Pointer values) {                       \
    if (hasTextureRange(context, pname)) [[unlikely]]                                              \
      return getRange(context, target, pname, values);                                             \
    if (!hasSgixShadow(context, pname)) [[likely]]                                                 \
      return context.host->name(target, hostName(context, pname), values);                         \
    GLint arb = 0;                                                                                 \
    context.host->GetTexParameteriv(target, arbShadowName(pname), &arb);                           \
    if (values)                                                                                    \
      *values = std::remove_pointer_t<Pointer>(sgixShadowValue(pname, arb));                       \
  }
BOUND_GETTER(GetTexParameteriv, GLint *)
BOUND_GETTER(GetTexParameterfv, GLfloat *)

// For a target or an object; for a texture or a unit, with a target.
#define SETTER(name, Object, Value)                                                                \
  void name(Context &context, Object object, GLenum pname, Value value) {                          \
    note(context, pname, value);                                                                   \
    context.host->name(object, hostName(context, pname, value), value);                            \
    noteTextureCommand(context);                                                                   \
  }
#define BOUND_SETTER(name, Object, Value)                                                          \
  void name(Context &context, Object target, GLenum pname, Value value) {                          \
    if (hasSgixShadow(context, pname)) [[unlikely]]                                                \
      return setShadow(context, target, pname, value);                                             \
    if (hasTextureRange(context, pname)) [[unlikely]]                                              \
      return setRange(context, target, pname, value);                                              \
    note(context, pname, value);                                                                   \
    context.host->name(target, hostName(context, pname, value), value);                            \
    noteTextureCommand(context);                                                                   \
  }
#define TARGET_SETTER(name, Object, Value)                                                         \
  void name(Context &context, Object object, GLenum target, GLenum pname, Value value) {           \
    note(context, pname, value);                                                                   \
    context.host->name(object, target, pname, value);                                              \
    noteTextureCommand(context);                                                                   \
  }
#define SETTERS(setter, prefix, suffix, Object)                                                    \
  setter(prefix##i##suffix, Object, GLint) setter(prefix##f##suffix, Object, GLfloat)              \
      setter(prefix##iv##suffix, Object, const GLint *)                                            \
          setter(prefix##fv##suffix, Object, const GLfloat *)                                      \
              setter(prefix##Iiv##suffix, Object, const GLint *)                                   \
                  setter(prefix##Iuiv##suffix, Object, const GLuint *)
SETTERS(BOUND_SETTER, TexParameter, , GLenum)
SETTERS(SETTER, TextureParameter, , GLuint)
SETTERS(SETTER, SamplerParameter, , GLuint)
SETTERS(TARGET_SETTER, TextureParameter, EXT, GLuint)
SETTERS(TARGET_SETTER, MultiTexParameter, EXT, GLenum)

void TextureRangeAPPLE(Context &context, GLenum target, GLsizei length, const void *pointer) {
  if (!hasTextureRange(context, GL_TEXTURE_RANGE_LENGTH_APPLE))
    return context.host->TextureRangeAPPLE(target, length, pointer);
  issueRange(context,
             {.kind = Command::Kind::TextureRange,
              .target = target,
              .count = length,
              .bytes = std::string(reinterpret_cast<const char *>(&pointer), sizeof pointer)});
}

void GetTexParameterPointervAPPLE(Context &context, GLenum target, GLenum pname, void **params) {
  if (!hasTextureRange(context, GL_TEXTURE_RANGE_LENGTH_APPLE))
    return context.host->GetTexParameterPointervAPPLE(target, pname, params);
  if (!outsideBeginEnd(context, "GetTexParameterPointerv between Begin and End"))
    return;
  TextureRange range;
  if (pname != GL_TEXTURE_RANGE_POINTER_APPLE)
    return raise(context, GL_INVALID_ENUM, "GetTexParameterPointerv: pname");
  if (getTextureRange(context, target, range) && params)
    *params = const_cast<void *>(range.pointer); // the application's own pointer
}

void BindSampler(Context &context, GLuint unit, GLuint sampler) {
  releaseSamplers(context);
  context.host->BindSampler(unit, sampler);
  noteTextureCommand(context);
}
void BindSamplers(Context &context, GLuint first, GLsizei count, const GLuint *samplers) {
  releaseSamplers(context);
  context.host->BindSamplers(first, count, samplers);
  noteTextureCommand(context);
}

} // namespace handlers
} // namespace arbiter::state
