#include "state/host_draw/linked_program.h"

#include <algorithm>
#include <cstdio>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/host_draw/undefined_results.h"
#include "state/report/capture.h"
#include "state/share/share_group.h"
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

bool isVertex(const CompiledProgram &compiled) { return compiled.target == Target::Vertex; }

/// 0 if the host does not compile it.
GLuint compileShader(Context &context, const CompiledProgram &compiled, const std::string &glsl) {
  const host::HostTable &host = *context.host;
  const GLuint shader =
      host.CreateShader(isVertex(compiled) ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
  if (shader == 0)
    return 0;
  const GLchar *const text = glsl.c_str();
  const auto length = GLint(glsl.size());
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

std::string nameOf(const ProgramPair &pair) {
  std::string name;
  for (const auto &compiled : {pair.vertex, pair.fragment})
    if (compiled)
      name += (name.empty() ? "" : " with ") + toHex(compiled->hash);
  return name;
}

/// A program of those of the two shaders that are not 0; 0 if the host refuses.
GLuint linkProgram(Context &context, const ProgramPair &pair, GLuint vertex, GLuint fragment) {
  const host::HostTable &host = *context.host;
  const GLuint program = host.CreateProgram();
  if (program == 0)
    return 0;
  if (pair.vertex)
    for (const fp::GlslAttribute &attribute : pair.vertex->glsl.attributes)
      host.BindAttribLocation(program, attribute.index, attribute.name.c_str());
  for (const GLuint shader : {vertex, fragment})
    if (shader != 0)
      host.AttachShader(program, shader);
  host.LinkProgram(program);
  for (const GLuint shader : {vertex, fragment})
    if (shader != 0)
      host.DetachShader(program, shader);
  GLint status = GL_FALSE;
  host.GetProgramiv(program, GL_LINK_STATUS, &status);
  if (status == GL_TRUE)
    return program;
  logError("state", "the host does not link the GLSL of program %s:\n%s", nameOf(pair).c_str(),
           infoLog(program, host.GetProgramiv, host.GetProgramInfoLog).c_str());
  host.DeleteProgram(program);
  return 0;
}

/// Samplers are set once: two of different types on one unit, which zero would give, is an error at
/// the draw. Requires the program to be current.
void setSamplers(Context &context, const LinkedProgram &linkedProgram) {
  for (const fp::GlslSampler &sampler : linkedProgram.fragment.compiled->glsl.samplers) {
    const GLint location =
        context.host->GetUniformLocation(linkedProgram.hostProgram, sampler.uniform.c_str());
    if (location >= 0)
      context.host->Uniform1i(location, sampler.unit);
  }
}

void findParameters(Context &context, GLuint hostProgram, LinkedProgramStage &stage) {
  const auto &uniforms = stage.compiled->glsl.uniforms;
  const char *const array = isVertex(*stage.compiled) ? "arb_vparam" : "arb_param";
  stage.uploaded.assign(uniforms.size(), Vec4{}); // the host's initial values
  stage.locations.resize(uniforms.size());
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    char name[40]; // the longer name, and any number
    std::snprintf(name, sizeof name, "%s[%zu]", array, i);
    stage.locations[i] = context.host->GetUniformLocation(hostProgram, name);
    stage.readsState |= uniforms[i].parameter.kind == fp::ir::ParameterKind::State;
  }
}

bool isPlain(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  return target != TexTarget::Shadow1D && target != TexTarget::Shadow2D &&
         target != TexTarget::ShadowRect;
}

/// The host's program becomes current, and its uniforms are found.
void setUp(Context &context, const ProgramPair &pair, LinkedProgram &linkedProgram) {
  context.host->UseProgram(linkedProgram.hostProgram);
  context.hostProgramIsOurs = true;
  for (LinkedProgramStage *stage : {&linkedProgram.vertex, &linkedProgram.fragment}) {
    if (!stage->compiled)
      continue;
    findParameters(context, linkedProgram.hostProgram, *stage);
    linkedProgram.readsState |= stage->readsState;
  }
  if (!pair.fragment)
    return;
  setSamplers(context, linkedProgram);
  const auto &samplers = pair.fragment->glsl.samplers;
  linkedProgram.hasPlainSamplers =
      std::any_of(samplers.begin(), samplers.end(),
                  [](const auto &sampler) { return isPlain(sampler.target); });
}

void destroy(Context &context, const LinkedProgram &linkedProgram) {
  if (linkedProgram.hostProgram == 0)
    return;
  context.group->removeHostProgram(linkedProgram.hostProgram);
  context.host->DeleteProgram(linkedProgram.hostProgram); // where current, when it is no longer
}

} // namespace

const LinkedProgramCache::Shader *
LinkedProgramCache::shaderOf(Context &context,
                             const std::shared_ptr<const CompiledProgram> &compiled) {
  const auto [it, isNew] = m_shaders.try_emplace(compiled.get());
  if (!isNew)
    return &it->second;
  GLuint name = 0;
  try {
    name = compileShader(context, *compiled, compiled->glsl.text);
    if (name != 0)
      context.group->addHostProgram(name);
  } catch (...) { // no memory: none was made
    if (name != 0)
      context.host->DeleteShader(name);
    m_shaders.erase(it);
    throw;
  }
  it->second = {compiled, name};
  return &it->second;
}

std::unique_ptr<LinkedProgram> LinkedProgramCache::build(Context &context,
                                                         const ProgramPair &pair) {
  auto linkedProgram = std::make_unique<LinkedProgram>();
  linkedProgram->vertex.compiled = pair.vertex.get();
  linkedProgram->fragment.compiled = pair.fragment.get();
  const HostErrorScope scope(*context.host, context.pendingError);
  GLuint shaders[2] = {};
  for (const auto &compiled : {pair.vertex, pair.fragment}) {
    if (!compiled)
      continue;
    GLuint &shader = shaders[isVertex(*compiled) ? 0 : 1];
    shader = shaderOf(context, compiled)->name;
    if (shader == 0)
      return linkedProgram;
  }
  // A shader of this pair's own where the two do not fit each other: rare.
  const std::string whole =
      pair.vertex && pair.fragment ? withMissingResults(*pair.vertex, *pair.fragment) : "";
  const GLuint own = whole.empty() ? 0 : compileShader(context, *pair.vertex, whole);
  linkedProgram->hostProgram = linkProgram(context, pair, own ? own : shaders[0], shaders[1]);
  if (own != 0)
    context.host->DeleteShader(own);
  if (linkedProgram->hostProgram == 0)
    return linkedProgram;
  try {
    context.group->addHostProgram(linkedProgram->hostProgram);
    setUp(context, pair, *linkedProgram);
  } catch (...) { // no memory
    destroy(context, *linkedProgram);
    throw;
  }
  return linkedProgram;
}

LinkedProgram *LinkedProgramCache::get(Context &context, const ProgramPair &pair) {
  const Key key = {pair.vertex.get(), pair.fragment.get()};
  const auto it = m_linkedPrograms.find(key);
  if (it != m_linkedPrograms.end())
    return it->second.get();
  if (m_shaders.size() >= m_sweepAt)
    sweep(context);
  std::unique_ptr<LinkedProgram> &made =
      m_linkedPrograms[key]; // its place first: a program is costlier
  try {
    made = build(context, pair);
  } catch (...) {
    m_linkedPrograms.erase(key);
    throw;
  }
  return made.get();
}

void LinkedProgramCache::drop(Context &context, const CompiledProgram *compiled) {
  const auto shader = m_shaders.find(compiled);
  if (shader == m_shaders.end())
    return;
  std::erase_if(m_linkedPrograms, [&](const auto &entry) {
    if (entry.first.vertex != compiled && entry.first.fragment != compiled)
      return false;
    if (context.linkedProgram == entry.second.get()) {
      captureLeave(context); // it holds the parameters of its last draw
      context.linkedProgram = nullptr;
    }
    destroy(context, *entry.second);
    return true;
  });
  if (shader->second.name != 0) {
    context.group->removeHostProgram(shader->second.name);
    context.host->DeleteShader(shader->second.name);
  }
  m_shaders.erase(shader);
}

/// Programs that left their object through another context: nothing else holds them any more.
void LinkedProgramCache::sweep(Context &context) {
  std::vector<const CompiledProgram *> left;
  for (const auto &[compiled, shader] : m_shaders) {
    const bool effective =
        context.linkedProgram && (context.linkedProgram->vertex.compiled == compiled ||
                                  context.linkedProgram->fragment.compiled == compiled);
    if (!effective && shader.compiled.use_count() == 1)
      left.push_back(compiled);
  }
  for (const CompiledProgram *const compiled : left)
    drop(context, compiled);
  m_sweepAt = std::max<std::size_t>(64, 2 * m_shaders.size());
}

LinkedProgramCache::Names LinkedProgramCache::abandon() {
  Names names;
  for (const auto &[key, linkedProgram] : m_linkedPrograms)
    if (linkedProgram->hostProgram != 0)
      names.programs.push_back(linkedProgram->hostProgram);
  for (const auto &[compiled, shader] : m_shaders)
    if (shader.name != 0)
      names.shaders.push_back(shader.name);
  m_linkedPrograms.clear();
  m_shaders.clear();
  return names;
}

} // namespace arbiter::state
