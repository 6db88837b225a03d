// Get, GetString and GetStringi: values that are the layer's, or that its host objects would
// change.
#include <algorithm>
#include <atomic>
#include <climits>
#include <cmath>
#include <type_traits>

#include "GL/arbiter.h"
#include "fp_compiler/ati/shader.h"
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/application_identity.h"
#include "state/core/errors.h"
#include "state/era/era_state.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/stages/stage_pipeline.h"
#include "state/host_draw/texturing/sampler_override.h"
#include "state/identity/active_profile.h"
#include "state/identity/identity.h"
#include "state/imaging/imaging_state.h"
#include "state/lists/list_compiler.h"
#include "state/pixel_commands/imaging_queries.h"
#include "state/programs/combiners/combiner_state.h"
#include "state/programs/nv/nv_state.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/programs/vertex_shaders/vertex_shader_state.h"
#include "state/raster_draw/context_state.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Gets a value of ATI_fragment_shader. All but the enable are constants (Deprecated
/// Functionality).
bool fragmentShaderValue(const ProgramTarget &row, GLenum pname, GLint &value) {
  constexpr GLint kComponents = 3;
  switch (pname) {
  case infoOf(Target::AtiApi).name:
    value = row.enabled ? 1 : 0;
    break;
  case GL_NUM_FRAGMENT_REGISTERS_ATI:
    value = fp::ati::kRegisters;
    break;
  case GL_NUM_FRAGMENT_CONSTANTS_ATI:
    value = fp::ati::kConstants;
    break;
  case GL_NUM_PASSES_ATI:
    value = fp::ati::kMaxPasses;
    break;
  case GL_NUM_INSTRUCTIONS_PER_PASS_ATI:
    value = fp::ati::kMaxPairs;
    break;
  case GL_NUM_INSTRUCTIONS_TOTAL_ATI:
    value = fp::ati::kMaxPasses * fp::ati::kMaxPairs;
    break;
  case GL_COLOR_ALPHA_PAIRING_ATI:
    value = GL_TRUE;
    break;
  default: // components of interpolators, and from pass to pass
    value = kComponents;
  }
  return row.offered;
}

/// Gets a limit that concerns more than programs. It is the card's only with
/// ARBITER_IDENTITY=profile: otherwise newer applications that draw without programs would lose by
/// it. The context's rows never exceed the host's limits.
bool cardValue(const Context &context, GLenum pname, GLint &value) {
  if (!settings().identityOfProfile || !context.offered)
    return false;
  const fp::Limits &fragment = context.row(Target::Fragment).limits;
  const fp::Limits &vertex = context.row(Target::Vertex).limits;
  const auto give = [&](std::uint32_t limit) {
    value = GLint(limit);
    return true;
  };
  switch (pname) {
  case GL_MAX_DRAW_BUFFERS:
    return give(fragment.drawBuffers);
  case GL_MAX_CLIP_PLANES:
    return give(fragment.clipPlanes);
  case GL_MAX_LIGHTS:
    return give(fragment.lights);
  case GL_MAX_PROGRAM_MATRICES_ARB:
    return give(fragment.programMatrices);
  case GL_MAX_PROGRAM_MATRIX_STACK_DEPTH_ARB:
    return give(fragment.programMatrixStackDepth);
  case GL_MAX_VERTEX_ATTRIBS:
    return give(vertex.vertexAttribs);
  default:
    return false;
  }
}

/// Gets a value of NV_vertex_program or NV_fragment_program for which the ARB has no name.
bool nvValue(const Context &context, GLenum pname, GLint &value) {
  if (!context.nv)
    return false;
  const ProgramTarget &fragment = context.row(Target::Fragment);
  if (pname == GL_VERTEX_PROGRAM_BINDING_NV)
    value = GLint(context.row(Target::Vertex).bound->name);
  else if (fragment.limits.nvOptions == 0)
    return false;
  else if (pname == GL_FRAGMENT_PROGRAM_BINDING_NV)
    value = GLint(fragment.bound->name);
  else
    value = GLint(fragment.limits.localParameters);
  return true;
}

/// Gets a value that the layer answers itself. Otherwise it returns false for the host, after
/// restoring state that would reveal the layer's objects.
bool ownValue(Context &context, GLenum pname, GLint &value) {
  switch (pname) {
  case infoOf(Target::Fragment).name:
  case infoOf(Target::Vertex).name:
  case infoOf(Target::AtiText).name:
  case GL_FRAGMENT_PROGRAM_NV:
    if (const ProgramTarget *const row = rowOf(context, pname)) {
      value = row->enabled ? 1 : 0;
      return true;
    }
    return false;
  case infoOf(Target::AtiApi).name:
  case GL_NUM_FRAGMENT_REGISTERS_ATI:
  case GL_NUM_FRAGMENT_CONSTANTS_ATI:
  case GL_NUM_PASSES_ATI:
  case GL_NUM_INSTRUCTIONS_PER_PASS_ATI:
  case GL_NUM_INSTRUCTIONS_TOTAL_ATI:
  case GL_NUM_INPUT_INTERPOLATOR_COMPONENTS_ATI:
  case GL_NUM_LOOPBACK_COMPONENTS_ATI:
  case GL_COLOR_ALPHA_PAIRING_ATI:
    return fragmentShaderValue(context.row(Target::AtiApi), pname, value);
  case GL_VERTEX_PROGRAM_BINDING_NV:
  case GL_FRAGMENT_PROGRAM_BINDING_NV:
  case GL_MAX_FRAGMENT_PROGRAM_LOCAL_PARAMETERS_NV:
    return nvValue(context, pname, value);
  case infoOf(Target::Combiners).name:
  case GL_NUM_GENERAL_COMBINERS_NV:
  case GL_COLOR_SUM_CLAMP_NV:
  case GL_MAX_GENERAL_COMBINERS_NV:
  case GL_PER_STAGE_CONSTANTS_NV:
    return combinerValue(context, pname, value);
  case infoOf(Target::TextureShaders).name:
    return textureShaderValue(context, value);
  case infoOf(Target::VertexShader).name:
  case GL_VERTEX_SHADER_BINDING_EXT:
  case GL_MAX_VERTEX_SHADER_INSTRUCTIONS_EXT:
  case GL_MAX_VERTEX_SHADER_VARIANTS_EXT:
  case GL_MAX_VERTEX_SHADER_INVARIANTS_EXT:
  case GL_MAX_VERTEX_SHADER_LOCAL_CONSTANTS_EXT:
  case GL_MAX_VERTEX_SHADER_LOCALS_EXT:
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_INSTRUCTIONS_EXT:
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_VARIANTS_EXT:
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_INVARIANTS_EXT:
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_LOCAL_CONSTANTS_EXT:
  case GL_MAX_OPTIMIZED_VERTEX_SHADER_LOCALS_EXT:
  case GL_VERTEX_SHADER_INSTRUCTIONS_EXT:
  case GL_VERTEX_SHADER_VARIANTS_EXT:
  case GL_VERTEX_SHADER_INVARIANTS_EXT:
  case GL_VERTEX_SHADER_LOCAL_CONSTANTS_EXT:
  case GL_VERTEX_SHADER_LOCALS_EXT:
  case GL_VERTEX_SHADER_OPTIMIZED_EXT:
    return vertexShaderValue(context, pname, value);
  case GL_TRANSFORM_HINT_APPLE:
  case GL_MULTISAMPLE_FILTER_HINT_NV:
  case GL_POINT_SPRITE_R_MODE_NV:
  case GL_VERTEX_ARRAY_RANGE_NV:
  case GL_VERTEX_ARRAY_RANGE_LENGTH_NV:
  case GL_VERTEX_ARRAY_RANGE_VALID_NV:
  case GL_MAX_VERTEX_ARRAY_RANGE_ELEMENT_NV:
  case GL_UNPACK_CLIENT_STORAGE_APPLE:
  case GL_VERTEX_ARRAY_BINDING:
    return eraValue(context, pname, value);
  case GL_PROGRAM_ERROR_POSITION_ARB:
    value = context.errors.position;
    return true;
  case GL_MAX_TEXTURE_COORDS:
    value = GLint(context.row(Target::Fragment).limits.textureCoords);
    return true;
  case GL_MAX_TEXTURE_IMAGE_UNITS:
    value = GLint(context.row(Target::Fragment).limits.textureImageUnits);
    return true;
  case GL_MAX_TEXTURE_UNITS:
    value = GLint(context.row(Target::Fragment).limits.textureUnits);
    return true;
  case GL_LIST_INDEX:
    if (!context.listMode)
      return false;
    value = GLint(listCompiler(context).name());
    return true;
  case GL_NUM_EXTENSIONS:
    if (context.caps.major < 3)
      return false;
    value = GLint(applicationIdentity(context).extensions.names.size());
    return true;
  case GL_MAJOR_VERSION:
  case GL_MINOR_VERSION: {
    const Identity &identity = applicationIdentity(context);
    if (context.caps.major < 3 || identity.major == 0)
      return false;
    value = pname == GL_MAJOR_VERSION ? identity.major : identity.minor;
    return true;
  }
  case GL_FEEDBACK_COPIES_ARBITER:
    value = GLint(std::min<std::uint64_t>(context.counters.feedback.copies(), INT_MAX));
    return context.offered;
  case GL_FEEDBACK_COPIES_AVOIDED_ARBITER:
    value = context.software ? GLint(std::min<std::uint64_t>(
                                   context.software->residency.statistics().copiesShared, INT_MAX))
                             : 0;
    return context.offered;
  case GL_CURRENT_PROGRAM: // the layer's program is current only if the application has none
    if (!context.hostProgramIsOurs)
      return false;
    value = 0;
    return true;
  case GL_PROGRAM_PIPELINE_BINDING: // the layer's pipeline reads as none
    value = 0;
    return context.hostSide.stagePipeline->isBound();
  case GL_SAMPLER_BINDING:
    if (context.hostSide.samplerOverride->active())
      releaseSamplers(context);
    return false;
  default:
    if (context.nv && isEvaluatorMap(pname)) {
      value = GLint(context.nv->enabledMaps >> evaluatorMapOf(pname) & 1u);
      return true;
    }
    return cardValue(context, pname, value);
  }
}

template <typename T> void give(GLint value, T *data) {
  if constexpr (std::is_same_v<T, GLboolean>)
    *data = value != 0 ? GL_TRUE : GL_FALSE;
  else
    *data = T(value);
}

/// Converts a colour component to the type of the query (OpenGL 1.2, 6.1.2: integers by table 4.7).
template <typename T> T colorComponent(GLfloat value) {
  if constexpr (std::is_same_v<T, GLboolean>)
    return value != 0.0f ? GL_TRUE : GL_FALSE;
  else if constexpr (std::is_integral_v<T>)
    return T(std::floor((4294967295.0 * double(value) - 1.0) / 2.0 + 0.5));
  else
    return T(value);
}

/// Gets a constant colour of register combiners. Returns false for other names.
template <typename T> bool getCombinerColor(const Context &context, GLenum pname, T *data) {
  const GLenum which = pname - GL_CONSTANT_COLOR0_NV;
  if (which > 1 || !context.combiners) [[likely]]
    return false;
  const Vec4 &color = context.combiners->constant(fp::combiners::globalConstant(int(which)));
  std::transform(color.begin(), color.end(), data, colorComponent<T>);
  return true;
}

/// Gets a scale or bias of HILO components or texture offset groups. Returns false for other names.
template <typename T> bool getTransfer(const Context &context, GLenum pname, T *data) {
  const GLenum at = pname - GL_HI_SCALE_NV;
  if (at > 11 || !hasTextureShaders(context)) [[likely]]
    return false;
  const ComponentTransfers &transfers = context.textureShaders->transfers;
  const GLfloat value = at < 6 ? transfers.scales[at] : transfers.biases[at - 6];
  if constexpr (std::is_same_v<T, GLboolean>)
    *data = value != 0.0f ? GL_TRUE : GL_FALSE;
  else if constexpr (std::is_integral_v<T>)
    *data = T(std::floor(double(value) + 0.5));
  else
    *data = T(value);
  return true;
}

/// Gets a value of ARB_imaging. Returns false for other names.
template <typename T> bool getImaging(Context &context, GLenum pname, T *data) {
  std::array<GLfloat, 16> values{};
  const int count = context.imaging ? imagingValues(context, pname, values) : 0;
  for (int i = 0; i < count; ++i)
    if constexpr (std::is_same_v<T, GLboolean>)
      data[i] = values[std::size_t(i)] != 0.0f ? GL_TRUE : GL_FALSE;
    else if constexpr (std::is_integral_v<T>)
      data[i] = wholeNumber<T>(double(values[std::size_t(i)]));
    else
      data[i] = T(values[std::size_t(i)]);
  return count != 0;
}

template <typename T, typename Host>
void getValue(Context &context, GLenum pname, T *data, Host host) {
  if (!context.insideBeginEnd && data &&
      (getCombinerColor(context, pname, data) || getTransfer(context, pname, data) ||
       getImaging(context, pname, data)))
    return;
  GLint value = 0;
  if (context.insideBeginEnd || !data || !ownValue(context, pname, value)) [[likely]]
    return host(pname, data);
  give(value, data);
}

const GLubyte *ownOrHost(const Context &context, GLenum name, const std::string &own) {
  return own.empty() ? context.host->GetString(name)
                     : reinterpret_cast<const GLubyte *>(own.c_str());
}

const GLubyte *shadingLanguage(Context &context, const Identity &identity) {
  if (!identity.hidesShadingLanguage)
    return ownOrHost(context, GL_SHADING_LANGUAGE_VERSION, identity.shadingLanguage);
  raise(context, GL_INVALID_ENUM, "GetString: SHADING_LANGUAGE_VERSION needs OpenGL 2.0");
  return nullptr;
}

} // namespace

namespace handlers {

void GetIntegerv(Context &context, GLenum pname, GLint *data) {
  getValue(context, pname, data, context.host->GetIntegerv);
}
void GetFloatv(Context &context, GLenum pname, GLfloat *data) {
  getValue(context, pname, data, context.host->GetFloatv);
}
void GetDoublev(Context &context, GLenum pname, GLdouble *data) {
  getValue(context, pname, data, context.host->GetDoublev);
}
void GetBooleanv(Context &context, GLenum pname, GLboolean *data) {
  getValue(context, pname, data, context.host->GetBooleanv);
}
void GetInteger64v(Context &context, GLenum pname, GLint64 *data) {
  getValue(context, pname, data, context.host->GetInteger64v);
}

const GLubyte *GetString(Context &context, GLenum name) {
  if (context.insideBeginEnd)
    return context.host->GetString(name);
  if (name == GL_PROGRAM_ERROR_STRING_ARB)
    return reinterpret_cast<const GLubyte *>(context.errors.text.c_str());
  if (!context.life.initialised)
    return context.host->GetString(name);
  const Identity &identity = applicationIdentity(context);
  switch (name) {
  case GL_EXTENSIONS:
    return reinterpret_cast<const GLubyte *>(identity.extensions.joined.c_str());
  case GL_VENDOR:
    return ownOrHost(context, name, identity.vendor);
  case GL_RENDERER:
    return ownOrHost(context, name, identity.renderer);
  case GL_VERSION:
    return ownOrHost(context, name, identity.version);
  case GL_SHADING_LANGUAGE_VERSION:
    return shadingLanguage(context, identity);
  default:
    return context.host->GetString(name);
  }
}

const GLubyte *GetStringi(Context &context, GLenum name, GLuint index) {
  if (name != GL_EXTENSIONS || context.insideBeginEnd || context.caps.major < 3)
    return context.host->GetStringi(name, index);
  const auto &names = applicationIdentity(context).extensions.names;
  if (index < names.size())
    return reinterpret_cast<const GLubyte *>(names[index].c_str());
  raise(context, GL_INVALID_VALUE, "GetStringi: index");
  return nullptr;
}

GLenum GetError(Context &context) { return takeError(context); }

} // namespace handlers
} // namespace arbiter::state
