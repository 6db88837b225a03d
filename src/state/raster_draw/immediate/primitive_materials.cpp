#include "state/raster_draw/immediate/primitive_materials.h"

#include <bit>
#include <cstring>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/pipeline.h"

namespace arbiter::state::software {

namespace {

constexpr MaterialMask kAllMaterials = (1u << 2 * kMaterialParts) - 1;

/// Bits of one side; 0: no name of Material's.
MaterialMask partsNamed(GLenum pname) {
  switch (pname) {
  case GL_EMISSION:
    return 1;
  case GL_AMBIENT:
    return 2;
  case GL_DIFFUSE:
    return 4;
  case GL_AMBIENT_AND_DIFFUSE:
    return 2 | 4;
  case GL_SPECULAR:
    return 8;
  case GL_SHININESS:
    return 16;
  default:
    return 0;
  }
}

MaterialMask onSides(MaterialMask parts, bool front, bool back) {
  return MaterialMask((front ? parts : 0) | (back ? parts << kMaterialParts : 0));
}

/// 0: an error.
MaterialMask materialsNamed(GLenum face, GLenum pname) {
  const bool both = face == GL_FRONT_AND_BACK;
  return onSides(partsNamed(pname), both || face == GL_FRONT, both || face == GL_BACK);
}

/// What is the colour's: Material leaves it as it is (2.14.3).
MaterialMask tracked(const VertexState &state) {
  return state.colorMaterial
             ? onSides(state.colorMaterialParts, (state.colorMaterialFace & 1u) != 0,
                       (state.colorMaterialFace & 2u) != 0)
             : MaterialMask(0);
}

/// The host's, behind what stands in for it.
std::array<float, 4> currentMaterial(const Context &context, int material) {
  std::array<float, 4> value{};
  context.trueHost->GetMaterialfv(material < kMaterialParts ? GL_FRONT : GL_BACK,
                                  materialName(material), value.data());
  return value;
}

/// What reaches pixels of materials that differ.
MaterialMask visible(const Context &context) {
  const VertexState &state = context.software->mirror.vertex;
  if (!state.lighting || !context.software->pipeline->hasFixedVertices())
    return 0;
  return state.twoSided ? kAllMaterials : kFrontMaterial;
}

} // namespace

bool recordsMaterial(ContextHot &hot, GLenum face, GLenum pname, const GLfloat *values) {
  const auto &context = static_cast<const Context &>(hot);
  if (!context.software || context.listMode != 0 ||
      context.recorder != &context.software->recorder || !values)
    return false;
  MaterialMask parts = materialsNamed(face, pname);
  if (parts == 0 || (pname == GL_SHININESS && !(values[0] >= 0 && values[0] <= 128)))
    return false;
  ContextState &state = *context.software;
  PrimitiveMaterials &materials = state.materials;
  std::array<float, 4> value{};
  std::memcpy(value.data(), values, (pname == GL_SHININESS ? 1 : 4) * sizeof(float));
  parts &= MaterialMask(~tracked(state.mirror.vertex));
  MaterialMask changing = 0;
  for (unsigned left = parts; left != 0; left &= left - 1) {
    const int material = std::countr_zero(left);
    const auto bit = MaterialMask(1u << material);
    if ((materials.m_known & bit) == 0) {
      materials.m_known |= bit;
      state.recorder.setFirst(kMaterial0 + material, currentMaterial(context, material));
    }
    const auto &before = state.recorder.values()[std::size_t(kMaterial0 + material)];
    if (std::memcmp(&before, &value, sizeof value) != 0)
      changing |= bit;
  }
  if (changing == 0)
    return true;
  if (state.pipeline->programReadsMaterials())
    return false;
  if (state.recorder.count() != 0)
    materials.m_differing |= changing;
  materials.m_given &= MaterialMask(~changing);
  for (unsigned left = changing; left != 0; left &= left - 1)
    state.recorder.set(kMaterial0 + std::countr_zero(left), value[0], value[1], value[2], value[3]);
  return true;
}

Outcome readyMaterials(Context &context) {
  ContextState &state = *context.software;
  PrimitiveMaterials &materials = state.materials;
  const MaterialMask touched = materialsIn(state.recorder.touched());
  if ((touched | materials.m_chosen) == 0 && !materials.m_isUndecided) [[likely]]
    return {};
  const auto common = MaterialMask(touched & ~(materials.m_differing | materials.m_given));
  const auto differing = MaterialMask(materials.m_differing & visible(context));
  if (common == 0 && differing == materials.m_chosen && !materials.m_isUndecided)
    return {};
  setCurrentValues(context, state.recorder.values(), slotsOfMaterials(common));
  materials.m_given |= common;
  materials.m_chosen = differing;
  const Outcome outcome = decideAgain(context, state.recorder.mode(), differing);
  materials.m_isUndecided = !outcome.ok();
  return outcome;
}

SlotMask slotsToSet(const Context &context) {
  const ContextState &state = *context.software;
  return state.recorder.touched() & ~slotsOfMaterials(state.materials.m_given);
}

} // namespace arbiter::state::software
