// Named parameters of !!FP1.0 programs (NV_fragment_program 3.11.1), which are local parameters
// after the numbered ones.
#include "state/core/errors.h"
#include "state/programs/nv/nv_programs.h"
#include "state/programs/parameters.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// A program and the index of its local parameter; the object is null after an error.
struct Named {
  std::shared_ptr<ProgramObject> object;
  std::size_t local = 0;
};

Named find(ProgramContext &context, GLuint id, std::string_view name) {
  std::shared_ptr<ProgramObject> object = existingProgram(context, id);
  if (!object || object->target != Target::Fragment) {
    raise(context, GL_INVALID_OPERATION, "NamedParameter: the id is no fragment program's");
    return {};
  }
  const auto compiled = context.group->compiledOf(*object);
  const fp::NamedParameter *const parameter = compiled ? compiled->native.find(name) : nullptr;
  if (!parameter || parameter->local >= object->locals.size()) {
    raise(context, GL_INVALID_VALUE, "NamedParameter: the program has none of that name");
    return {};
  }
  return {std::move(object), parameter->local};
}

} // namespace

void setNamedParameter(ProgramContext &context, GLuint id, std::string_view name,
                       host::ParameterValues values) {
  const Named named = find(context, id, name);
  if (!named.object)
    return;
  named.object->locals[named.local].store(values.read());
  noteLocalsChanged(context, *named.object);
}

bool namedParameter(ProgramContext &context, GLuint id, std::string_view name, Vec4 &value) {
  const Named named = find(context, id, name);
  if (named.object)
    value = named.object->locals[named.local].load();
  return named.object != nullptr;
}

} // namespace arbiter::state
