#include "state/variant.h"

#include <algorithm>
#include <bit>
#include <cstdio>

#include "host/host_table.h"
#include "state/context.h"
#include "state/errors.h"
#include "state/share_group.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// The info log of a shader or program, for our log.
template <typename GetIv, typename GetLog>
std::string infoLog(GLuint object, GetIv getIv, GetLog getLog) {
  GLint length = 0;
  getIv(object, GL_INFO_LOG_LENGTH, &length);
  if (length <= 0)
    return {};
  std::string text(std::size_t(length), '\0');
  GLsizei written = 0;
  getLog(object, length, &written, text.data());
  text.resize(std::size_t(std::clamp<GLsizei>(written, 0, length)));
  return text;
}

/// 0 if the host does not compile it.
GLuint compileShader(Context &context, const CompiledProgram &compiled) {
  const host::HostTable &host = *context.host;
  const GLuint shader = host.CreateShader(GL_FRAGMENT_SHADER);
  if (shader == 0)
    return 0;
  const GLchar *const text = compiled.glsl.text.c_str();
  const auto length = GLint(compiled.glsl.text.size());
  host.ShaderSource(shader, 1, &text, &length);
  host.CompileShader(shader);
  GLint status = GL_FALSE;
  host.GetShaderiv(shader, GL_COMPILE_STATUS, &status);
  if (status == GL_TRUE)
    return shader;
  logError("state", "the host does not compile the GLSL of program %s:\n%s",
           toHex(compiled.hash).c_str(),
           infoLog(shader, host.GetShaderiv, host.GetShaderInfoLog).c_str());
  host.DeleteShader(shader);
  return 0;
}

/// A linked program of the fragment stage alone; 0 if the host refuses.
GLuint linkProgram(Context &context, const CompiledProgram &compiled) {
  const host::HostTable &host = *context.host;
  const GLuint shader = compileShader(context, compiled);
  if (shader == 0)
    return 0;
  const GLuint program = host.CreateProgram();
  if (program != 0) {
    host.AttachShader(program, shader);
    host.LinkProgram(program);
    host.DetachShader(program, shader);
  }
  host.DeleteShader(shader);
  if (program == 0)
    return 0;
  GLint status = GL_FALSE;
  host.GetProgramiv(program, GL_LINK_STATUS, &status);
  if (status == GL_TRUE)
    return program;
  logError("state", "the host does not link the GLSL of program %s:\n%s",
           toHex(compiled.hash).c_str(),
           infoLog(program, host.GetProgramiv, host.GetProgramInfoLog).c_str());
  host.DeleteProgram(program);
  return 0;
}

/// Samplers are set once: two of different types on one unit, which zero would give, is an error at
/// the draw. Requires the program to be current.
void setSamplers(Context &context, const Variant &variant) {
  for (const fp::GlslSampler &sampler : variant.compiled->glsl.samplers) {
    const GLint location =
        context.host->GetUniformLocation(variant.hostProgram, sampler.uniform.c_str());
    if (location >= 0)
      context.host->Uniform1i(location, sampler.unit);
  }
}

void findParameters(Context &context, Variant &variant) {
  const auto &uniforms = variant.compiled->glsl.uniforms;
  variant.uploaded.assign(uniforms.size(), Vec4{}); // the host's initial values
  variant.locations.resize(uniforms.size());
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "arb_param[%zu]", i);
    variant.locations[i] = context.host->GetUniformLocation(variant.hostProgram, name);
    variant.readsState |= uniforms[i].parameter.kind == fp::ir::ParameterKind::State;
  }
  variant.readsParameters = !uniforms.empty();
}

bool isPlain(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  return target != TexTarget::Shadow1D && target != TexTarget::Shadow2D &&
         target != TexTarget::ShadowRect;
}

std::unique_ptr<Variant> build(Context &context,
                               const std::shared_ptr<const CompiledProgram> &compiled) {
  auto variant = std::make_unique<Variant>();
  variant->compiled = compiled;
  const HostErrorScope scope(context);
  variant->hostProgram = linkProgram(context, *compiled);
  if (variant->hostProgram == 0)
    return variant;
  context.group->addHostProgram(variant->hostProgram);
  context.host->UseProgram(variant->hostProgram);
  context.hostProgramIsOurs = true;
  setSamplers(context, *variant);
  findParameters(context, *variant);
  const auto &samplers = compiled->glsl.samplers;
  variant->hasPlainSamplers =
      std::any_of(samplers.begin(), samplers.end(),
                  [](const auto &sampler) { return isPlain(sampler.target); });
  return variant;
}

void destroy(Context &context, const Variant &variant) {
  if (variant.hostProgram == 0)
    return;
  context.group->removeHostProgram(variant.hostProgram);
  context.host->DeleteProgram(variant.hostProgram); // where current, when it is no longer
}

} // namespace

Variant *VariantCache::get(Context &context,
                           const std::shared_ptr<const CompiledProgram> &compiled) {
  if (!m_map)
    m_map = std::make_unique<Map>();
  const auto it = m_map->find(compiled.get());
  if (it != m_map->end())
    return it->second.get();
  if (m_map->size() >= m_sweepAt)
    sweep(context);
  return m_map->emplace(compiled.get(), build(context, compiled)).first->second.get();
}

void VariantCache::drop(Context &context, const CompiledProgram *compiled) {
  if (!m_map)
    return;
  const auto it = m_map->find(compiled);
  if (it == m_map->end())
    return;
  if (context.variant == it->second.get()) {
    captureLeave(context); // it holds the parameters of its last draw
    context.variant = nullptr;
  }
  destroy(context, *it->second);
  m_map->erase(it);
}

/// Variants whose program left its object through another context: nobody else holds it any more.
void VariantCache::sweep(Context &context) {
  std::erase_if(*m_map, [&](const auto &entry) {
    const Variant &variant = *entry.second;
    if (variant.compiled.use_count() > 1 || context.variant == &variant)
      return false;
    destroy(context, variant);
    return true;
  });
  m_sweepAt = std::max<std::size_t>(64, 2 * m_map->size());
}

std::vector<GLuint> VariantCache::abandon() {
  std::vector<GLuint> names;
  if (m_map) {
    for (const auto &[compiled, variant] : *m_map)
      if (variant->hostProgram != 0)
        names.push_back(variant->hostProgram);
    m_map->clear();
  }
  return names;
}

namespace {

/// The value that element `i` of arb_param has to have.
void currentValue(Context &context, const ProgramTarget &row, const fp::ir::Parameter &parameter,
                  Vec4 &value) {
  switch (parameter.kind) {
  case fp::ir::ParameterKind::Constant:
    value = parameter.constant;
    break;
  case fp::ir::ParameterKind::Env:
    if (parameter.index < row.env.size())
      value = row.env[parameter.index];
    break;
  case fp::ir::ParameterKind::Local:
    if (parameter.index < row.bound->locals.size())
      value = row.bound->locals[parameter.index].load();
    break;
  case fp::ir::ParameterKind::State:
    fetchState(context, parameter.state, value.data());
    break;
  }
}

} // namespace

void uploadParameters(Context &context, Variant &variant) {
  const auto &uniforms = variant.compiled->glsl.uniforms;
  const std::size_t count = uniforms.size();
  std::size_t begin = 0; // of the run of changed values, as far as it goes
  std::size_t end = 0;
  const auto flush = [&] {
    if (begin != end)
      context.host->Uniform4fv(variant.locations[begin], GLsizei(end - begin),
                               variant.uploaded[begin].data());
    begin = end = 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (variant.locations[i] < 0)
      continue;
    Vec4 value{};
    currentValue(context, context.row(variant.compiled->target), uniforms[i].parameter, value);
    // Bits, not values: a NaN would be sent for ever, and -0 never.
    if (std::bit_cast<std::array<std::uint32_t, 4>>(value) ==
        std::bit_cast<std::array<std::uint32_t, 4>>(variant.uploaded[i]))
      continue;
    variant.uploaded[i] = value;
    const bool joins = begin != end && end == i &&
                       variant.locations[i] == variant.locations[begin] + GLint(i - begin);
    if (!joins) {
      flush();
      begin = i;
    }
    end = i + 1;
  }
  flush();
}

} // namespace arbiter::state
