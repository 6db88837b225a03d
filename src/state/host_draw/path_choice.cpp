#include "state/host_draw/path_choice.h"

#include "fp_compiler/ir/ir.h"
#include "host/host_table.h"
#include "state/core/context_hooks.h"
#include "state/host_draw/clip_planes.h"
#include "state/host_draw/draw_context.h"
#include "state/host_draw/fixed_function.h"
#include "state/host_draw/linking/fragment_assembly.h"
#include "state/host_draw/linking/host_assembly.h"
#include "state/host_draw/linking/linked_program_cache.h"
#include "state/host_draw/native_inputs.h"
#include "state/host_draw/stages/application_glsl.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/host_draw/texturing/combiner_draw.h"
#include "state/host_draw/texturing/texture_shader_draw.h"
#include "state/objects/linked_program.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/program_edits.h"
#include "state/programs/program_load.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/variants/alpha_depths.h"
#include "state/programs/variants/array_variants.h"
#include "state/programs/variants/ati_variants.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/programs/variants/depth_variants.h"
#include "state/programs/variants/point_sprites.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Returns the application's current GLSL program. It is the host's CURRENT_PROGRAM unless the
/// layer's is bound. Only the host knows whether a UseProgram succeeded and what a list did, so it
/// is queried once after each.
GLuint applicationProgram(DrawContext &context) {
  if (!context.application.programKnown && !context.hostProgramIsOurs) {
    GLint current = 0;
    context.host->GetIntegerv(GL_CURRENT_PROGRAM, &current);
    context.application.program = GLuint(current);
    context.application.programKnown = true;
  }
  return context.application.program;
}

GLuint applicationPipeline(DrawContext &context) {
  GLint pipeline = 0;
  if (context.application.pipelinesUsed && !context.hostSide.stagePipeline->isBound())
    context.host->GetIntegerv(GL_PROGRAM_PIPELINE_BINDING, &pipeline);
  return GLuint(pipeline);
}

/// The targets whose programs shade now; null for stages of fixed function or the application's
/// GLSL.
struct EffectivePrograms {
  const ProgramTarget *vertex = nullptr;
  const ProgramTarget *fragment = nullptr;
  /// true if an ATI fragment shader of either form is enabled, and there is no `fragment`
  bool ati = false;
  bool combiners = false; ///< true if register combiners are enabled, and there is no `fragment`
  /// True if there is no `fragment`, and texture shaders are enabled, or fixed function uses
  /// textures, environments or sprites that the host lacks.
  bool textureShaders = false;
  [[nodiscard]] bool none() const {
    return !vertex && !fragment && !ati && !combiners && !textureShaders;
  }
};

EffectivePrograms enabledRows(DrawContext &context) {
  const auto ifEnabled = [&](Target target) {
    const ProgramTarget &row = context.row(target);
    return row.enabled && !isSwitchedOff(context, row) ? &row : nullptr;
  };
  EffectivePrograms rows = {ifEnabled(Target::Vertex), ifEnabled(Target::Fragment)};
  if (!rows.vertex)
    rows.vertex = vertexShaderEffective(context);
  rows.ati = !rows.fragment && (ifEnabled(Target::AtiText) || ifEnabled(Target::AtiApi));
  rows.combiners = !rows.fragment && ifEnabled(Target::Combiners);
  // Combiners that follow texture shaders belong to the texture shaders' text.
  const bool shaders =
      ifEnabled(Target::TextureShaders) && !texturesSwitchedOff(context, rows.combiners);
  if (rows.combiners && !shaders && combinersSwitchedOff(context))
    rows.combiners = false;
  rows.textureShaders =
      !rows.fragment && (shaders || texturesNeedLayer(context) ||
                         (spriteForm(context).units != 0 && !rows.ati && !rows.combiners));
  return rows;
}

/// False if the stages sample different targets of one unit, which makes draws an error
/// (NV_vertex_program3, section 2.14.4).
bool targetsAgree(const ProgramPair &pair) {
  if (!pair.vertex || !pair.fragment || pair.vertex->glsl.samplers.empty()) [[likely]]
    return true;
  for (const fp::GlslSampler &vertex : pair.vertex->glsl.samplers)
    for (const fp::GlslSampler &fragment : pair.fragment->glsl.samplers)
      if (vertex.unit == fragment.unit && vertex.target != fragment.target)
        return false;
  return true;
}

/// Fetches the compiled programs of the targets. Returns false if one has no valid program, or if
/// they do not match. An ATI shader that is not valid leaves fragments to fixed function.
bool takePrograms(DrawContext &context, const EffectivePrograms &rows, ProgramPair &pair) {
  if (rows.vertex)
    pair.vertex = context.group->compiledOf(*rows.vertex->bound);
  if (context.aliases && pair.vertex && pair.vertex->arrays)
    pair.vertex = withItsAttributes(context, *pair.vertex);
  if (rows.fragment)
    pair.fragment = context.group->compiledOf(*rows.fragment->bound);
  else if (rows.ati)
    pair.fragment = chooseAtiShaderProgram(context);
  if (rows.textureShaders && !pair.fragment)
    pair.fragment = chooseTextureShaderProgram(context, glslHost(context.caps), rows.combiners);
  else if (rows.combiners && !pair.fragment)
    pair.fragment = chooseCombinerProgram(context, glslHost(context.caps));
  return (!rows.vertex || pair.vertex) && (!rows.fragment || pair.fragment) && targetsAgree(pair);
}

/// True if a program is too long for the host's GLSL compiler. Mesa's recurses along chains of
/// instructions, and overflowed its stack with a program of 16,000 POW, which its assembly parser
/// accepts. Legacy and Fp24 numerics need GLSL anyway.
bool isTooLongForGlsl(const DrawContext &context, const ProgramPair &pair) {
  constexpr std::size_t kLong = 4096; // instructions
  const auto isLong = [](const std::shared_ptr<const CompiledProgram> &compiled) {
    return compiled && compiled->program && compiled->program->code.size() > kLong;
  };
  return context.numerics == fp::Numerics::Host && (isLong(pair.vertex) || isLong(pair.fragment));
}

/// Links a pair whose vertex program is GLSL on the host.
LinkedProgram *linkGlsl(DrawContext &context, ProgramPair pair) {
  // A vertex program that is linked alone keeps all its results, for feedback and the raster
  // position.
  if (!context.rasterizes || context.vertexResultsMatter)
    pair.fragment = nullptr;
  if (clipPlanesMatter(context)) {
    const bool distances = writesClipDistances(*pair.vertex) && context.caps.clipDistances();
    const std::uint8_t planes = distances ? enabledClipPlanes(context) : std::uint8_t(0);
    std::uint32_t depths = 0;
    if (planes != 0) { // needs GLSL 1.30
      if (context.group->alphaDepthsUsed.load(std::memory_order_relaxed))
        depths = alphaDepthsOf(context, pair);
      context.effective.alphaDepths = depths;
      if (pair.fragment && pair.fragment->depths)
        pair.fragment = pair.fragment->depths->of(*pair.fragment, depths);
    }
    pair.vertex = pair.vertex->clipped->of(*pair.vertex, planes, depths);
  }
  LinkedProgram *const linkedProgram = context.hostSide.linkedPrograms->get(
      context, pair, fragmentsOf(context, pair)); // as in link()
  context.stagesAreLinked =
      context.stagesAreLinked || (pair.fragment && linkedProgram->vertexProgram == 0);
  return linkedProgram;
}

/// True if the host part may be deferred, because the rasterizer may draw with the pair. While
/// back-off keeps the host it may not, because each draw would choose twice.
bool mayWait(DrawContext &context, const ProgramPair &pair) {
  if (pair.fragment)
    context.hooks->engageRasterizer(context);
  return context.hooks->rasterizerDraws(context) &&
         (!pair.vertex || drawsVerticesByAssembly(context));
}

/// True if planes are enabled and the host's own assembly would clip the program wrongly.
bool isClippedOtherwise(DrawContext &context, const CompiledProgram &vertex) {
  return assemblyClipsOtherwise(context, vertex) && clipPlanesMatter(context);
}

/// Draws both stages with the host's own assembly. Returns false if that is not possible.
bool applyAssembly(DrawContext &context, const ProgramPair &pair) {
  return !(pair.vertex && isClippedOtherwise(context, *pair.vertex)) &&
         context.hostSide.assembly->apply(context, pair);
}

LinkedProgram *link(DrawContext &context, const ProgramPair &pair) {
  if (pair.vertex &&
      (!drawsVerticesByAssembly(context) || isClippedOtherwise(context, *pair.vertex)))
    return linkGlsl(context, pair);
  LinkedProgram *const linkedProgram =
      context.hostSide.linkedPrograms->get(context, pair, fragmentsOf(context, pair));
  if (pair.vertex && !linkedProgram->vertexAssembly) // the host refuses it as assembly
    return linkGlsl(context, pair);
  return linkedProgram;
}

} // namespace

bool applicationShades(DrawContext &context) {
  return applicationProgram(context) != 0 || applicationPipeline(context) != 0;
}

Path choosePath(DrawContext &context, HostPart part) {
  context.effective.linkedProgram = nullptr;
  context.effective.hostPartWaits = false;
  context.stagesAreLinked = false;
  context.effective.alphaDepths.reset();
  context.followsFixedFunction = false;
  if (context.textureShaders)
    context.textureShaders->effective = false;
  if (context.combiners)
    context.combiners->effective = false;
  if (context.vertexShaders)
    context.vertexShaders->effective = nullptr;
  for (ProgramTarget &row : context.targets)
    if (row.enabled)
      row.seenVersion = row.bound->version.load(std::memory_order_acquire);
  EffectivePrograms rows = enabledRows(context);
  if (rows.none())
    return Path::NoProgram;
  const GLuint program = applicationProgram(context);
  const GLuint pipeline = program == 0 ? applicationPipeline(context) : 0;
  GlslStages theirs;
  if (program != 0)
    theirs = stagesOf(context, program);
  else if (pipeline != 0)
    theirs = stagesOfPipeline(context, pipeline);
  if (theirs.vertex)
    rows.vertex = nullptr;
  if (theirs.fragment) {
    rows.fragment = nullptr;
    rows.ati = rows.combiners = rows.textureShaders = false;
  }
  if (rows.none())
    return program != 0 ? Path::ApplicationGlsl : Path::ApplicationPipeline;

  ProgramPair pair;
  if (!takePrograms(context, rows, pair))
    return Path::InvalidProgram;
  if (pair.fragment && pair.fragment->depths)
    pair.fragment = pair.fragment->depths->ofSprites(*pair.fragment, spriteForm(context));
  if (!pair.vertex && !pair.fragment)
    return Path::NoProgram;
  // RasterPos looks then, because no shader of EXT_vertex_shader transforms the raster position.
  context.stagesAreLinked = pair.vertex && pair.vertex->target == Target::VertexShader;
  // If the application's GLSL has one stage, the ARB program has the other one, as beside fixed
  // function. The layer's GLSL cannot be linked to the application's. A pipeline without stages is
  // left to the host: Mesa draws nothing with it, NVIDIA's driver uses the ARB programs.
  if (program != 0 || pipeline != 0)
    return applyAssembly(context, pair) ? Path::HostAssembly
           : theirs.none()              ? Path::ApplicationPipeline
                                        : Path::ApplicationStageGlsl;
  if (isTooLongForGlsl(context, pair) && applyAssembly(context, pair))
    return Path::HostAssembly;
  if (part == HostPart::WhenItDraws && mayWait(context, pair)) {
    context.effective.linkedProgram = context.hostSide.linkedPrograms->place(context, pair);
    context.effective.hostPartWaits = true;
    return Path::HostGlsl;
  }
  LinkedProgram *const linkedProgram = link(context, pair);
  if (linkedProgram->refused)
    return Path::HostRefused;
  context.effective.linkedProgram = linkedProgram;
  return linkedProgram->hostProgram != 0 ? Path::HostGlsl : Path::HostAssembly;
}

} // namespace arbiter::state
