#include "state/host_draw/texturing/sampler_override.h"

#include "host/host_table.h"
#include "state/host_draw/draw_context.h"
#include "state/objects/linked_program.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Returns the texture target of a plain sampler; 0 for SHADOW targets, which are meant to compare.
GLenum plainTarget(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  switch (target) {
  case TexTarget::Tex1D:
    return GL_TEXTURE_1D;
  case TexTarget::Tex2D:
    return GL_TEXTURE_2D;
  case TexTarget::Tex3D:
    return GL_TEXTURE_3D;
  case TexTarget::Cube:
    return GL_TEXTURE_CUBE_MAP;
  case TexTarget::Rect:
    return GL_TEXTURE_RECTANGLE;
  case TexTarget::Shadow1D:
  case TexTarget::Shadow2D:
  case TexTarget::ShadowRect:
    return 0;
  }
  return 0;
}

constexpr GLenum kIntegers[] = {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
                                GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
constexpr GLenum kFloats[] = {GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_LOD_BIAS};

/// Copies parameters of the application's texture or sampler to `uncompared`.
/// \param getIv, getFv read the parameters
template <typename GetIv, typename GetFv>
void copyParameters(DrawContext &context, GLuint uncompared, GetIv getIv, GetFv getFv) {
  const host::HostTable &host = *context.host;
  for (const GLenum pname : kIntegers) {
    GLint value = 0;
    getIv(pname, &value);
    host.SamplerParameteri(uncompared, pname, value);
  }
  for (const GLenum pname : kFloats) {
    GLfloat value = 0.0f;
    getFv(pname, &value);
    host.SamplerParameterfv(uncompared, pname, &value);
  }
  GLfloat border[4] = {};
  getFv(GL_TEXTURE_BORDER_COLOR, border);
  host.SamplerParameterfv(uncompared, GL_TEXTURE_BORDER_COLOR, border);
  if (context.caps.anisotropy) {
    GLfloat value = 1.0f;
    getFv(GL_TEXTURE_MAX_ANISOTROPY_EXT, &value);
    host.SamplerParameterfv(uncompared, GL_TEXTURE_MAX_ANISOTROPY_EXT, &value);
  }
  host.SamplerParameteri(uncompared, GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

} // namespace

void SamplerOverride::applyUnit(DrawContext &context, const fp::GlslSampler &sampler) {
  const GLenum target = plainTarget(sampler.target);
  if (target == 0 || sampler.unit >= kMaxUnits)
    return;
  const host::HostTable &host = *context.host;
  host.ActiveTexture(GL_TEXTURE0 + sampler.unit);
  GLint bound = 0;
  host.GetIntegerv(GL_SAMPLER_BINDING, &bound);
  GLint compare = GL_NONE;
  if (bound != 0)
    host.GetSamplerParameteriv(GLuint(bound), GL_TEXTURE_COMPARE_MODE, &compare);
  else
    host.GetTexParameteriv(target, GL_TEXTURE_COMPARE_MODE, &compare);
  if (compare == GL_NONE)
    return;

  Unit &unit = m_units[sampler.unit];
  if (unit.uncompared == 0)
    host.GenSamplers(1, &unit.uncompared);
  if (unit.uncompared == 0)
    return;
  if (bound != 0)
    copyParameters(
        context, unit.uncompared,
        [&](GLenum pname, GLint *v) { host.GetSamplerParameteriv(GLuint(bound), pname, v); },
        [&](GLenum pname, GLfloat *v) { host.GetSamplerParameterfv(GLuint(bound), pname, v); });
  else
    copyParameters(
        context, unit.uncompared,
        [&](GLenum pname, GLint *v) { host.GetTexParameteriv(target, pname, v); },
        [&](GLenum pname, GLfloat *v) { host.GetTexParameterfv(target, pname, v); });
  unit.application = GLuint(bound);
  host.BindSampler(sampler.unit, unit.uncompared);
  m_active |= 1u << sampler.unit;
}

void SamplerOverride::apply(DrawContext &context, const LinkedProgram &linkedProgram) {
  release(context);
  GLint active = GL_TEXTURE0;
  context.host->GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  // A unit that both stages read is handled once: after that it no longer compares.
  for (const LinkedProgramStage *stage : {&linkedProgram.vertex, &linkedProgram.fragment})
    if (stage->compiled)
      for (const fp::GlslSampler &sampler : stage->compiled->glsl.samplers)
        applyUnit(context, sampler);
  context.host->ActiveTexture(GLenum(active));
}

void SamplerOverride::release(DrawContext &context) {
  for (GLuint unit = 0; m_active >> unit != 0 && unit < kMaxUnits; ++unit)
    if ((m_active >> unit & 1u) != 0)
      context.host->BindSampler(unit, m_units[unit].application);
  m_active = 0;
}

bool SamplerOverride::owns(GLuint sampler) const {
  if (sampler == 0)
    return false;
  for (const Unit &unit : m_units)
    if (unit.uncompared == sampler)
      return true;
  return false;
}

std::vector<GLuint> SamplerOverride::abandon() {
  std::vector<GLuint> names;
  for (Unit &unit : m_units) {
    if (unit.uncompared != 0)
      names.push_back(unit.uncompared);
    unit = {};
  }
  m_active = 0;
  return names;
}

void releaseSamplers(DrawContext &context) {
  if (!context.hostSide.samplerOverride->active())
    return;
  context.hostSide.samplerOverride->release(context);
  context.attention |= attention::kCompare;
}

} // namespace arbiter::state
