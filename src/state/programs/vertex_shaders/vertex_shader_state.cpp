#include "state/programs/vertex_shaders/vertex_shader_state.h"

#include <array>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/imaging/imaging_state.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

Vec4 followedValue(ProgramContext &context, const VertexSymbol &symbol, std::size_t row) {
  Vec4 value{};
  if (symbol.follows == VertexSymbol::Follows::SpotCutoff) {
    context.host->GetLightfv(GL_LIGHT0 + symbol.light, GL_SPOT_CUTOFF, value.data());
    return value;
  }
  std::array<GLfloat, 16> matrix{};
  if (!context.imaging || imagingValues(context, GL_COLOR_MATRIX, matrix) == 0)
    context.host->GetFloatv(GL_COLOR_MATRIX, matrix.data());
  for (std::size_t column = 0; column < 4; ++column)
    value[column] = matrix[4 * column + row];
  return value;
}

namespace {

ProgramTarget &shaderRow(ProgramContext &context) { return context.row(Target::VertexShader); }

/// Sets the target's env parameters to the shader's invariants, or, if `all` is false, only to
/// those that follow GL parameters.
void takeValues(ProgramContext &context, const VertexShaderInputs &inputs, bool all) {
  ProgramTarget &row = shaderRow(context);
  bool changed = false;
  for (std::size_t i = 0; i < inputs.env.size(); ++i) {
    const VertexShaderInputs::Row &from = inputs.env[i];
    const bool follows = from.symbol->follows != VertexSymbol::Follows::Nothing;
    if (!follows && !all)
      continue;
    const Vec4 value = follows ? followedValue(context, *from.symbol, from.row)
                               : from.symbol->value[from.row].load();
    changed = changed || value != row.env[i];
    row.env[i] = value;
  }
  if (!changed)
    return;
  ++row.envVersion;
  context.attention |= row.parameterBits;
}

} // namespace

void bindVertexShader(ProgramContext &context, GLuint name) {
  if (context.vertexShaders->recorder)
    return raise(context, GL_INVALID_OPERATION,
                 "BindVertexShader between Begin- and EndVertexShader");
  ProgramTarget &row = shaderRow(context);
  std::shared_ptr<ProgramObject> object = name == 0
                                              ? context.group->defaultProgram(Target::VertexShader)
                                              : context.group->vertexShaders.findOrCreate(name);
  if (row.bound == object && row.seenVersion == object->version.load(std::memory_order_acquire))
    return;
  row.bound = std::move(object);
  invalidateProgram(context);
}

void setInvariant(ProgramContext &context, GLuint name, const std::vector<Vec4> &rows) {
  VertexSymbolTable &table = context.group->vertexSymbols;
  const std::shared_ptr<VertexSymbol> symbol = table.find(name);
  if (!symbol)
    return;
  for (std::size_t row = 0; row < rows.size() && row < symbol->value.size(); ++row)
    symbol->value[row].store(rows[row]);
  table.valueChanged();
  if (context.vertexShaders->effective)
    context.attention |= shaderRow(context).parameterBits; // makes the next draw look
}

const ProgramTarget *vertexShaderEffective(ProgramContext &context) {
  if (!context.vertexShaders)
    return nullptr;
  VertexShaderState &state = *context.vertexShaders;
  state.effective = nullptr;
  const ProgramTarget &row = shaderRow(context);
  if (!row.enabled)
    return nullptr;
  const auto compiled = context.group->compiledOf(*row.bound);
  if (!compiled || !compiled->vertexShader->fits)
    return nullptr;
  state.effective = compiled->vertexShader;
  state.seenValues = context.group->vertexSymbols.version();
  takeValues(context, *state.effective, true);
  return &row;
}

void refreshVertexShader(ProgramContext &context) {
  VertexShaderState &state = *context.vertexShaders;
  if (!state.effective)
    return;
  const std::uint64_t version = context.group->vertexSymbols.version();
  const bool all = version != state.seenValues;
  if (!all && !state.effective->follows)
    return;
  state.seenValues = version;
  takeValues(context, *state.effective, all);
}

bool vertexShaderFollows(const ProgramContext &context) {
  return context.vertexShaders && context.vertexShaders->effective &&
         context.vertexShaders->effective->follows;
}

bool vertexShaderValue(const ProgramContext &context, GLenum pname, GLint &value) {
  if (!context.vertexShaders)
    return false;
  const ProgramTarget &row = context.row(Target::VertexShader);
  const auto compiled = context.group->compiledOf(*row.bound);
  static const VertexShaderInputs s_none{.optimized = false};
  const VertexShaderInputs &inputs = compiled ? *compiled->vertexShader : s_none;
  const fp::ResourceCounts &api = row.limits.api, &native = row.limits.native;
  const auto give = [&](GLuint number) {
    value = GLint(number);
    return true;
  };
  switch (pname) {
  case GL_VERTEX_SHADER_EXT:
    return give(row.enabled ? 1 : 0);
  case GL_VERTEX_SHADER_BINDING_EXT:
    return give(row.bound->name);
  case GL_MAX_VERTEX_SHADER_INSTRUCTIONS_EXT:
    return give(api.instructions);
  case GL_MAX_VERTEX_SHADER_VARIANTS_EXT:
    return give(api.attribs);
  case GL_MAX_VERTEX_SHADER_INVARIANTS_EXT:
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_INVARIANTS_EXT:
    return give(row.limits.envParameters);
  case GL_MAX_VERTEX_SHADER_LOCAL_CONSTANTS_EXT:
    return give(api.parameters);
  case GL_MAX_VERTEX_SHADER_LOCALS_EXT:
    return give(api.temporaries);
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_INSTRUCTIONS_EXT:
    return give(native.instructions);
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_VARIANTS_EXT:
    return give(native.attribs);
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_LOCAL_CONSTANTS_EXT:
    return give(native.parameters);
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_LOCALS_EXT:
    return give(native.temporaries);
  case GL_VERTEX_SHADER_INSTRUCTIONS_EXT:
    return give(inputs.instructions);
  case GL_VERTEX_SHADER_VARIANTS_EXT:
    return give(inputs.variants);
  case GL_VERTEX_SHADER_INVARIANTS_EXT:
    return give(inputs.invariants);
  case GL_VERTEX_SHADER_LOCAL_CONSTANTS_EXT:
    return give(inputs.localConstants);
  case GL_VERTEX_SHADER_LOCALS_EXT:
    return give(inputs.locals);
  case GL_VERTEX_SHADER_OPTIMIZED_EXT:
    return give(inputs.optimized ? 1 : 0);
  default:
    return false;
  }
}

} // namespace arbiter::state
