#include "state/host_draw/linking/linked_program_cache.h"

#include <algorithm>
#include <cstdio>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/linking/host_objects.h"
#include "state/host_draw/linking/undefined_results.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/report/capture.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Sets the samplers to their units, once. Otherwise all would use unit 0, and two types on one
/// unit are an error at the draw. Requires the program to be current.
void setSamplers(DrawContext &context, GLuint hostProgram, const CompiledProgram &compiled) {
  for (const fp::GlslSampler &sampler : compiled.glsl.samplers) {
    const GLint location = context.host->GetUniformLocation(hostProgram, sampler.uniform.c_str());
    if (location >= 0)
      context.host->Uniform1i(location, sampler.unit);
  }
}

bool readsState(const CompiledProgram &compiled) {
  const auto &uniforms = compiled.glsl.uniforms;
  return std::any_of(uniforms.begin(), uniforms.end(), [](const fp::GlslUniform &uniform) {
    return uniform.parameter.kind == fp::ir::ParameterKind::State;
  });
}

void findParameters(DrawContext &context, GLuint hostProgram, LinkedProgramStage &stage) {
  const auto &uniforms = stage.compiled->glsl.uniforms;
  const char *const array = isVertex(*stage.compiled) ? "arb_vparam" : "arb_param";
  stage.uploaded.assign(uniforms.size(), Vec4{}); // the host's initial values
  stage.locations.resize(uniforms.size());
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    char name[40]; // room for the longer name and any number
    std::snprintf(name, sizeof name, "%s[%zu]", array, i);
    stage.locations[i] = context.host->GetUniformLocation(hostProgram, name);
  }
  stage.readsState = readsState(*stage.compiled);
}

bool isPlain(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  return target != TexTarget::Shadow1D && target != TexTarget::Shadow2D &&
         target != TexTarget::ShadowRect;
}

bool hasPlainSamplers(const CompiledProgram &compiled) {
  return std::any_of(compiled.glsl.samplers.begin(), compiled.glsl.samplers.end(),
                     [](const auto &sampler) { return isPlain(sampler.target); });
}

/// Makes the host's program current, and looks up the uniforms of the given stages.
void setUp(DrawContext &context, GLuint hostProgram,
           std::initializer_list<LinkedProgramStage *> stages, LinkedProgram &linkedProgram) {
  context.hostSide.stagePipeline->useAlone(context, hostProgram);
  for (LinkedProgramStage *const stage : stages) {
    if (!stage->compiled)
      continue;
    findParameters(context, hostProgram, *stage);
    setSamplers(context, hostProgram, *stage->compiled);
    linkedProgram.readsState |= stage->readsState;
    linkedProgram.hasPlainSamplers |= hasPlainSamplers(*stage->compiled);
  }
}

/// Returns the host's programs that belong to this linked program alone.
std::array<GLuint, 2> ownPrograms(const LinkedProgram &linkedProgram) {
  return {linkedProgram.vertexAlone ? 0 : linkedProgram.vertexProgram,
          linkedProgram.fragmentAlone ? 0 : linkedProgram.hostProgram};
}

void destroy(DrawContext &context, const LinkedProgram &linkedProgram) {
  for (const GLuint program : ownPrograms(linkedProgram)) {
    if (program == 0)
      continue;
    context.hostSide.stagePipeline->forget(context, program);
    context.group->removeHostProgram(program);
    context.host->DeleteProgram(program); // if current, deleted when it no longer is
  }
}

/// Registers a host program that was just linked for `linkedProgram`, and sets it up.
void keep(DrawContext &context, GLuint hostProgram,
          std::initializer_list<LinkedProgramStage *> stages, LinkedProgram &linkedProgram) {
  try {
    context.group->addHostProgram(hostProgram);
    setUp(context, hostProgram, stages, linkedProgram);
  } catch (...) { // no memory
    destroy(context, linkedProgram);
    throw;
  }
}

void takeVertices(LinkedProgram *alone, LinkedProgram &linkedProgram) {
  linkedProgram.vertexAlone = alone;
  linkedProgram.vertexProgram = alone->hostProgram;
  linkedProgram.readsState |= alone->readsState;
  linkedProgram.hasPlainSamplers |= alone->hasPlainSamplers;
}

void takeFragments(LinkedProgram *alone, LinkedProgram &linkedProgram) {
  linkedProgram.fragmentAlone = alone;
  linkedProgram.refused = alone->refused;
  linkedProgram.hostProgram = alone->hostProgram;
  linkedProgram.readsState |= alone->readsState;
  linkedProgram.hasPlainSamplers |= alone->hasPlainSamplers;
}

} // namespace

bool drawsVerticesByAssembly(const DrawContext &context) {
  return context.caps.vertexProgram && context.numerics == fp::Numerics::Host;
}

LinkedProgramCache::HostObjects &
LinkedProgramCache::objectsOf(const std::shared_ptr<const CompiledProgram> &compiled) {
  HostObjects &objects = m_objects[compiled.get()];
  objects.compiled = compiled;
  return objects;
}

GLuint LinkedProgramCache::shaderOf(DrawContext &context,
                                    const std::shared_ptr<const CompiledProgram> &compiled) {
  HostObjects &objects = objectsOf(compiled);
  if (objects.shader)
    return *objects.shader;
  const GLuint name = compileShader(context, *compiled, compiled->glsl.text);
  try {
    if (name != 0)
      context.group->addHostProgram(name);
  } catch (...) { // no memory: as if none had been made
    context.host->DeleteShader(name);
    throw;
  }
  objects.shader = name;
  return name;
}

AssemblyProgram *
LinkedProgramCache::assemblyOf(DrawContext &context,
                               const std::shared_ptr<const CompiledProgram> &compiled,
                               const std::vector<fp::ir::Output> &defined) {
  auto &all = objectsOf(compiled).assembly;
  const auto known = std::find_if(all.begin(), all.end(),
                                  [&](const auto &each) { return each->defined == defined; });
  if (known != all.end())
    return (*known)->name != 0 ? known->get() : nullptr;
  auto made = std::make_unique<AssemblyProgram>();
  made->stage.compiled = compiled.get();
  made->stage.uploaded.assign(compiled->glsl.uniforms.size(), Vec4{}); // the host's initial values
  const auto &uniforms = compiled->glsl.uniforms;
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    using fp::ir::ParameterKind;
    const fp::ir::Parameter &parameter = uniforms[i].parameter;
    if (parameter.kind == ParameterKind::Env || parameter.kind == ParameterKind::Local ||
        capturing())
      made->given.push_back({parameter.kind, parameter.index, std::uint32_t(i)});
    if (parameter.kind != ParameterKind::Local)
      continue;
    if (parameter.index >= made->localPlaces.size())
      made->localPlaces.resize(parameter.index + 1, AssemblyProgram::kNoPlace);
    made->localPlaces[parameter.index] = std::uint32_t(i);
  }
  made->defined = defined;
  all.reserve(all.size() + 1); // reserved first, so that the object cannot be lost
  made->name = loadAssembly(context, *compiled, defined);
  AssemblyProgram *const assembly = all.emplace_back(std::move(made)).get();
  return assembly->name != 0 ? assembly : nullptr;
}

bool LinkedProgramCache::buildOnAssembly(DrawContext &context, const ProgramPair &pair,
                                         Fragments fragments, LinkedProgram &linkedProgram) {
  linkedProgram.vertexAssembly =
      pair.fragment ? assemblyOf(context, pair.vertex, missingResults(*pair.vertex, *pair.fragment))
                    : assemblyOf(context, pair.vertex);
  if (!linkedProgram.vertexAssembly)
    return false;
  linkedProgram.readsState = capturing() && readsState(*pair.vertex);
  const bool isTaken = fragments == Fragments::Assembly &&
                       takeFragmentAssembly(context, pair.fragment, linkedProgram);
  if (pair.fragment && !isTaken)
    takeFragments(get(context, {nullptr, pair.fragment}), linkedProgram);
  return true;
}

bool LinkedProgramCache::takeFragmentAssembly(
    DrawContext &context, const std::shared_ptr<const CompiledProgram> &fragment,
    LinkedProgram &linkedProgram) {
  linkedProgram.fragmentAssembly = assemblyOf(context, fragment);
  linkedProgram.readsState |= capturing() && readsState(*fragment);
  return linkedProgram.fragmentAssembly != nullptr;
}

/// Links the stages apart. A vertex program that must define additional results for this fragment
/// program belongs to this pair alone. All others are linked once for all of their pairs.
bool LinkedProgramCache::buildApart(DrawContext &context, const ProgramPair &pair,
                                    LinkedProgram &linkedProgram) {
  if (!context.hostSide.stagePipeline->make(context))
    return false;
  LinkedProgram *const fragments = get(context, {nullptr, pair.fragment});
  const std::string whole =
      glslWithResults(*pair.vertex, missingResults(*pair.vertex, *pair.fragment));
  if (whole.empty()) {
    LinkedProgram *const vertices = get(context, {pair.vertex, nullptr});
    if (vertices->hostProgram == 0)
      return false;
    takeVertices(vertices, linkedProgram);
  } else {
    const GLuint shader = compileShader(context, *pair.vertex, whole);
    if (shader == 0)
      return false;
    linkedProgram.vertexProgram = linkProgram(context, {pair.vertex, nullptr}, shader, 0);
    context.host->DeleteShader(shader);
    if (linkedProgram.vertexProgram == 0)
      return false;
    keep(context, linkedProgram.vertexProgram, {&linkedProgram.vertex}, linkedProgram);
  }
  takeFragments(fragments, linkedProgram);
  return true;
}

void LinkedProgramCache::build(DrawContext &context, const ProgramPair &pair, Fragments fragments,
                               LinkedProgram &linkedProgram) {
  const HostErrorScope scope(*context.host, context.errors.pending);
  if (pair.vertex && drawsVerticesByAssembly(context) &&
      buildOnAssembly(context, pair, fragments, linkedProgram))
    return;
  if (!pair.vertex && fragments == Fragments::Assembly &&
      takeFragmentAssembly(context, pair.fragment, linkedProgram))
    return;
  if (pair.vertex && pair.fragment && stagesStandApart(context) &&
      buildApart(context, pair, linkedProgram))
    return;
  linkedProgram.refused = true; // until it is linked
  GLuint shaders[2] = {};
  for (const auto &compiled : {pair.vertex, pair.fragment}) {
    if (!compiled)
      continue;
    GLuint &shader = shaders[isVertex(*compiled) ? 0 : 1];
    shader = shaderOf(context, compiled);
    if (shader == 0)
      return;
  }
  // If the two stages do not match, which is rare, the pair gets a vertex shader of its own.
  const std::string whole =
      pair.vertex && pair.fragment
          ? glslWithResults(*pair.vertex, missingResults(*pair.vertex, *pair.fragment))
          : "";
  const GLuint own = whole.empty() ? 0 : compileShader(context, *pair.vertex, whole);
  linkedProgram.hostProgram = linkProgram(context, pair, own ? own : shaders[0], shaders[1]);
  if (own != 0)
    context.host->DeleteShader(own);
  if (linkedProgram.hostProgram == 0)
    return;
  linkedProgram.refused = false;
  keep(context, linkedProgram.hostProgram, {&linkedProgram.vertex, &linkedProgram.fragment},
       linkedProgram);
}

LinkedProgram *LinkedProgramCache::place(DrawContext &context, const ProgramPair &pair,
                                         Fragments fragments) {
  const Key key = {pair.vertex.get(), pair.fragment.get(), fragments};
  const auto it = m_linkedPrograms.find(key);
  if (it != m_linkedPrograms.end())
    return it->second.get();
  if (m_objects.size() >= m_sweepAt)
    sweep(context);
  for (const auto &compiled : {pair.vertex, pair.fragment})
    if (compiled)
      (void)objectsOf(compiled); // keeps the program alive
  auto made = std::make_unique<LinkedProgram>();
  made->vertex.compiled = pair.vertex.get();
  made->fragment.compiled = pair.fragment.get();
  return m_linkedPrograms.emplace(key, std::move(made)).first->second.get();
}

LinkedProgram *LinkedProgramCache::get(DrawContext &context, const ProgramPair &pair,
                                       Fragments fragments) {
  LinkedProgram *const linkedProgram = place(context, pair, fragments);
  if (linkedProgram->built)
    return linkedProgram;
  try {
    build(context, pair, fragments, *linkedProgram);
  } catch (...) { // no memory: leave it as place() made it
    *linkedProgram = {.vertex = {.compiled = pair.vertex.get()},
                      .fragment = {.compiled = pair.fragment.get()}};
    throw;
  }
  linkedProgram->built = true;
  linkedProgram->frame = context.counters.frames;
  return linkedProgram;
}

const LinkedProgram *LinkedProgramCache::find(const ProgramPair &pair, Fragments fragments) const {
  const auto found = m_linkedPrograms.find({pair.vertex.get(), pair.fragment.get(), fragments});
  return found != m_linkedPrograms.end() ? found->second.get() : nullptr;
}

void LinkedProgramCache::deleteObjects(DrawContext &context, const HostObjects &objects) {
  if (const GLuint shader = objects.shader.value_or(0)) {
    context.group->removeHostProgram(shader);
    context.host->DeleteShader(shader);
  }
  for (const auto &assembly : objects.assembly) {
    if (assembly->name == 0)
      continue;
    context.hostSide.assembly->forget(context, assembly.get());
    context.host->DeleteProgramsARB(1, &assembly->name);
  }
}

void LinkedProgramCache::drop(DrawContext &context, const CompiledProgram *compiled) {
  const auto objects = m_objects.find(compiled);
  if (objects == m_objects.end())
    return;
  std::erase_if(m_linkedPrograms, [&](const auto &entry) {
    if (entry.first.vertex != compiled && entry.first.fragment != compiled)
      return false;
    if (context.effective.linkedProgram == entry.second.get()) {
      captureLeave(context); // a capture reads the parameters of its last draw
      context.effective.linkedProgram = nullptr;
    }
    destroy(context, *entry.second);
    return true;
  });
  deleteObjects(context, objects->second);
  m_objects.erase(objects);
}

/// Drops programs that left their object through another context, so that nothing else holds them.
void LinkedProgramCache::sweep(DrawContext &context) {
  std::vector<const CompiledProgram *> left;
  for (const auto &[compiled, objects] : m_objects) {
    const bool effective = context.hostSide.assembly->runs(compiled) ||
                           (context.effective.linkedProgram &&
                            (context.effective.linkedProgram->vertex.compiled == compiled ||
                             context.effective.linkedProgram->fragment.compiled == compiled));
    if (!effective && objects.compiled.use_count() == 1)
      left.push_back(compiled);
  }
  for (const CompiledProgram *const compiled : left)
    drop(context, compiled);
  m_sweepAt = std::max<std::size_t>(64, 2 * m_objects.size());
}

LinkedProgramCache::Names LinkedProgramCache::abandon() {
  Names names;
  for (const auto &[key, linkedProgram] : m_linkedPrograms)
    for (const GLuint program : ownPrograms(*linkedProgram))
      if (program != 0)
        names.programs.push_back(program);
  for (const auto &[compiled, objects] : m_objects) {
    if (objects.shader.value_or(0) != 0)
      names.shaders.push_back(*objects.shader);
    for (const auto &assembly : objects.assembly)
      if (assembly->name != 0)
        names.assembly.push_back(assembly->name);
  }
  m_linkedPrograms.clear();
  m_objects.clear();
  return names;
}

} // namespace arbiter::state
