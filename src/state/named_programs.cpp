// The program API by object name (EXT_direct_state_access). Its program text must not reach the
// host's parser either, and its objects are the ones that BindProgram knows.
#include <algorithm>
#include <cstring>

#include "host/handlers.h"
#include "host/host_table.h"
#include "state/errors.h"
#include "state/program_api.h"
#include "state/share_group.h"

namespace arbiter::state {

namespace {

/// The object of that name, made at first use as BindProgram would; null after an error.
std::shared_ptr<ProgramObject> named(Context &context, GLuint name) {
  if (!outsideBeginEnd(context, "NamedProgram between Begin and End"))
    return nullptr;
  if (name == 0)
    return context.group->defaultFragmentProgram();
  auto object =
      context.group->findOrCreate(name, GL_FRAGMENT_PROGRAM_ARB, context.limits.localParameters);
  if (object->target == GL_FRAGMENT_PROGRAM_ARB)
    return object;
  raise(context, GL_INVALID_OPERATION, "NamedProgram: the object has the other target");
  return nullptr;
}

void set(Context &context, GLuint name, GLuint index, const Vec4 &value) {
  if (const auto object = named(context, name))
    setLocal(context, *object, index, 1, &value);
}

const Vec4 *get(Context &context, GLuint name, GLuint index) {
  const auto object = named(context, name);
  if (!object)
    return nullptr;
  if (index < object->locals.size())
    return &object->locals[index];
  raise(context, GL_INVALID_VALUE, "GetNamedProgramLocalParameter: index");
  return nullptr;
}

} // namespace

namespace handlers {

void NamedProgramStringEXT(Context &context, GLuint program, GLenum target, GLenum format,
                           GLsizei len, const void *string) {
  if (target == GL_FRAGMENT_PROGRAM_ARB) {
    noteProgramApiUse(context);
    if (const auto object = named(context, program))
      loadFragmentProgram(context, *object, format, len, string);
    return;
  }
  if (target != GL_VERTEX_PROGRAM_ARB)
    return context.host->NamedProgramStringEXT(program, target, format, len, string);
  // The host's parser is reached through the checked entry alone.
  if (!outsideBeginEnd(context, "NamedProgramString between Begin and End"))
    return;
  GLint bound = 0;
  context.host->GetProgramivARB(target, GL_PROGRAM_BINDING_ARB, &bound);
  BindProgramARB(context, target, program);
  loadVertexProgram(context, format, len, string);
  context.host->BindProgramARB(target, GLuint(bound));
}

void NamedProgramLocalParameter4fEXT(Context &context, GLuint program, GLenum target, GLuint index,
                                     GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->NamedProgramLocalParameter4fEXT(program, target, index, x, y, z, w);
  set(context, program, index, {x, y, z, w});
}

void NamedProgramLocalParameter4fvEXT(Context &context, GLuint program, GLenum target, GLuint index,
                                      const GLfloat *params) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->NamedProgramLocalParameter4fvEXT(program, target, index, params);
  set(context, program, index, {params[0], params[1], params[2], params[3]});
}

void NamedProgramLocalParameter4dEXT(Context &context, GLuint program, GLenum target, GLuint index,
                                     GLdouble x, GLdouble y, GLdouble z, GLdouble w) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->NamedProgramLocalParameter4dEXT(program, target, index, x, y, z, w);
  set(context, program, index, {GLfloat(x), GLfloat(y), GLfloat(z), GLfloat(w)});
}

void NamedProgramLocalParameter4dvEXT(Context &context, GLuint program, GLenum target, GLuint index,
                                      const GLdouble *params) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->NamedProgramLocalParameter4dvEXT(program, target, index, params);
  set(context, program, index,
      {GLfloat(params[0]), GLfloat(params[1]), GLfloat(params[2]), GLfloat(params[3])});
}

void NamedProgramLocalParameters4fvEXT(Context &context, GLuint program, GLenum target,
                                       GLuint index, GLsizei count, const GLfloat *params) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->NamedProgramLocalParameters4fvEXT(program, target, index, count, params);
  if (count < 0 || std::size_t(count) > context.limits.localParameters)
    return raise(context, GL_INVALID_VALUE, "NamedProgramLocalParameters: count");
  std::vector<Vec4> values(std::size_t(count), Vec4{});
  if (count > 0)
    std::memcpy(values.data(), params, values.size() * sizeof(Vec4));
  if (const auto object = named(context, program))
    setLocal(context, *object, index, count, values.data());
}

void GetNamedProgramLocalParameterfvEXT(Context &context, GLuint program, GLenum target,
                                        GLuint index, GLfloat *params) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->GetNamedProgramLocalParameterfvEXT(program, target, index, params);
  if (const Vec4 *value = get(context, program, index))
    std::copy(value->begin(), value->end(), params);
}

void GetNamedProgramLocalParameterdvEXT(Context &context, GLuint program, GLenum target,
                                        GLuint index, GLdouble *params) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->GetNamedProgramLocalParameterdvEXT(program, target, index, params);
  if (const Vec4 *value = get(context, program, index))
    std::copy(value->begin(), value->end(), params);
}

void GetNamedProgramivEXT(Context &context, GLuint program, GLenum target, GLenum pname,
                          GLint *params) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->GetNamedProgramivEXT(program, target, pname, params);
  const auto object = named(context, program);
  if (object && !queryProgram(context, *object, pname, params))
    raise(context, GL_INVALID_ENUM, "GetNamedProgramiv: pname");
}

void GetNamedProgramStringEXT(Context &context, GLuint program, GLenum target, GLenum pname,
                              void *string) {
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->GetNamedProgramStringEXT(program, target, pname, string);
  const auto object = named(context, program);
  if (!object)
    return;
  if (pname != GL_PROGRAM_STRING_ARB)
    return raise(context, GL_INVALID_ENUM, "GetNamedProgramString: pname");
  const auto compiled = context.group->compiledOf(*object);
  if (compiled && string)
    std::memcpy(string, compiled->text.data(), compiled->text.size());
}

} // namespace handlers
} // namespace arbiter::state
