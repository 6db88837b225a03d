#include "state/raster_draw/program_state.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "fp_compiler/ir/ir.h"
#include "state/core/host_state.h"
#include "state/programs/program_edits.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

bool isMatrix(const fp::ir::StateRef &state) {
  using fp::ir::StateItem;
  return state.item >= StateItem::MatrixModelview && state.item <= StateItem::MatrixProgram;
}

bool sameMatrix(fp::ir::StateRef a, fp::ir::StateRef b) {
  a.row = b.row = 0;
  return a == b;
}

/// True if any bit differs: a NaN equals itself, and -0 differs from 0.
bool differ(const Vec4 &a, const Vec4 &b) {
  using Bits = std::array<std::uint32_t, 4>;
  return std::bit_cast<Bits>(a) != std::bit_cast<Bits>(b);
}

} // namespace

std::uint32_t dirtyGroupsOf(const fp::ir::StateRef &state) {
  using fp::ir::StateItem;
  switch (state.item) {
  case StateItem::MaterialAmbient:
  case StateItem::MaterialDiffuse:
  case StateItem::MaterialSpecular:
  case StateItem::MaterialEmission:
  case StateItem::LightModelSceneColor:
  case StateItem::LightProdAmbient:
  case StateItem::LightProdDiffuse:
  case StateItem::LightProdSpecular:
    // COLOR_MATERIAL makes these follow the current colour.
    return dirty::kLighting | dirty::kMaterial | dirty::kCurrent;
  case StateItem::MaterialShininess:
    return dirty::kLighting | dirty::kMaterial;
  case StateItem::LightAmbient:
  case StateItem::LightDiffuse:
  case StateItem::LightSpecular:
  case StateItem::LightPosition:
  case StateItem::LightAttenuation:
  case StateItem::LightSpotDirection:
  case StateItem::LightHalf:
  case StateItem::LightModelAmbient:
    return dirty::kLighting;
  case StateItem::TexEnvColor:
    return dirty::kTextureParameters;
  case StateItem::FogColor:
  case StateItem::FogParams:
  case StateItem::FogFactors:
    return dirty::kFog;
  case StateItem::DepthRange:
    return dirty::kViewport;
  case StateItem::MatrixModelview:
  case StateItem::MatrixMvp:
  case StateItem::MatrixPalette: // the modelview matrix on hosts without a palette
    return dirty::kTransform | dirty::kModelview;
  case StateItem::MatrixProjection:
  case StateItem::MatrixTexture:
  case StateItem::MatrixProgram:
  case StateItem::ClipPlane:
    return dirty::kTransform;
  case StateItem::TexGenEye:
  case StateItem::TexGenObject:
    return dirty::kTexGen;
  case StateItem::PointSize:
  case StateItem::PointAttenuation:
    return dirty::kRaster;
  }
  return ~0u;
}

ProgramValues::ProgramValues(const fp::ir::Program &program)
    : m_values(std::max<std::size_t>(program.parameters.size(), 1)) {
  for (std::size_t i = 0; i < program.parameters.size(); ++i) {
    const fp::ir::Parameter &parameter = program.parameters[i];
    const auto row = std::uint16_t(i);
    switch (parameter.kind) {
    case fp::ir::ParameterKind::Constant:
      m_values[i] = parameter.constant;
      break;
    case fp::ir::ParameterKind::Env:
      m_env.push_back({row, parameter.index});
      break;
    case fp::ir::ParameterKind::Local:
      m_local.push_back({row, parameter.index});
      break;
    case fp::ir::ParameterKind::State:
      m_states.push_back({row, dirtyGroupsOf(parameter.state), parameter.state});
      m_groups |= m_states.back().groups;
      break;
    }
  }
}

bool ProgramValues::set(std::size_t row, const Vec4 &value) {
  if (!differ(m_values[row], value))
    return false;
  m_values[row] = value;
  return true;
}

bool ProgramValues::updateParameters(const ProgramTarget &target) {
  bool changed = false;
  for (const Indexed &env : m_env)
    changed |= set(env.row, env.index < target.env.size() ? target.env[env.index] : Vec4{});
  const auto &locals = target.bound->locals;
  for (const Indexed &local : m_local)
    changed |= set(local.row, local.index < locals.size() ? locals[local.index].load() : Vec4{});
  return changed;
}

bool ProgramValues::update(RasterContext &context, const GenerationCounter &clock,
                           const ProgramTarget *target) {
  bool changed = false;
  if (target) {
    // Read before the values, so that a concurrent change by another thread is seen next time.
    const Versions now = {context.effective.selections,
                          target->bound->version.load(std::memory_order_acquire),
                          target->envVersion};
    if (!(now == m_versions)) {
      m_versions = now;
      changed = updateParameters(*target);
      if (anyHeld()) [[unlikely]]
        for (const bool env : {true, false})
          for (const Indexed &parameter : env ? m_env : m_local)
            if (const auto value = findHeld(context, *target, env, parameter.index))
              changed |= set(parameter.row, *value);
    }
  }
  const std::uint32_t groups = clock.changedSince(m_seen) & m_groups;
  m_seen = clock.now();
  if (groups == 0) [[likely]]
    return changed;
  return updateStates(context, groups) || changed;
}

bool ProgramValues::updateStates(RasterContext &context, std::uint32_t groups) {
  bool changed = false;
  // Rows of one matrix mostly follow each other, so the matrix is queried once.
  const fp::ir::StateRef *matrix = nullptr;
  GLfloat rows[4][4];
  for (const State &state : m_states) {
    if ((state.groups & groups) == 0)
      continue;
    Vec4 value{};
    if (isMatrix(state.state)) {
      if (!matrix || !sameMatrix(*matrix, state.state))
        fetchMatrix(context, state.state, rows);
      matrix = &state.state;
      std::copy_n(rows[state.state.row & 3u], 4, value.begin());
    } else {
      fetchState(context, state.state, value.data());
    }
    changed |= set(state.row, value);
  }
  return changed;
}

} // namespace arbiter::state
