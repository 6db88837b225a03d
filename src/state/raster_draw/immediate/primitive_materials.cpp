#include "state/raster_draw/immediate/primitive_materials.h"

#include <bit>
#include <cstring>

#include "host/host_table.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"
#include "util/numbers/same_bits.h"

namespace arbiter::state {

namespace {

/// Returns the parts of one side that glMaterial's `pname` sets; 0 for an invalid name.
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

/// Returns the parts that glMaterial sets; 0 for invalid arguments.
MaterialMask materialsNamed(GLenum face, GLenum pname) {
  const bool both = face == GL_FRONT_AND_BACK;
  return onSides(partsNamed(pname), both || face == GL_FRONT, both || face == GL_BACK);
}

/// Returns the parts that track the colour, which Material does not change (2.14.3).
MaterialMask tracked(const VertexState &state) {
  return state.colorMaterial
             ? onSides(state.colorMaterialParts, (state.colorMaterialFace & 1u) != 0,
                       (state.colorMaterialFace & 2u) != 0)
             : MaterialMask(0);
}

/// Returns the current material of the real host.
std::array<float, 4> currentMaterial(const RasterContext &context, int material) {
  std::array<float, 4> value{};
  context.trueHost->GetMaterialfv(material < kMaterialParts ? GL_FRONT : GL_BACK,
                                  materialName(material), value.data());
  return value;
}

} // namespace

bool recordsMaterial(ContextHot &hot, GLenum face, GLenum pname, const GLfloat *values) {
  const auto &context = static_cast<const RasterContext &>(hot);
  if (!context.software || context.listMode != 0 ||
      context.recorder != &context.software->recorder || !values)
    return false;
  MaterialMask parts = materialsNamed(face, pname);
  if (parts == 0 || (pname == GL_SHININESS && !(values[0] >= 0 && values[0] <= 128)))
    return false;
  ContextState &state = *context.software;
  MaterialParts &materials = state.materials;
  std::array<float, 4> value{};
  std::memcpy(value.data(), values, (pname == GL_SHININESS ? 1 : 4) * sizeof(float));
  parts &= MaterialMask(~tracked(state.mirror.vertex));
  MaterialMask changing = 0;
  for (unsigned left = parts; left != 0; left &= left - 1) {
    const int material = std::countr_zero(left);
    const auto bit = MaterialMask(1u << material);
    if ((materials.known & bit) == 0) {
      materials.known |= bit;
      state.recorder.setFirst(kMaterial0 + material, currentMaterial(context, material));
    }
    const auto &before = state.recorder.values()[std::size_t(kMaterial0 + material)];
    if (!sameBits(before, value))
      changing |= bit;
  }
  if (changing == 0)
    return true;
  if (!materials.mayDiffer)
    return false;
  if (state.recorder.count() != 0)
    materials.differing |= changing;
  materials.given &= MaterialMask(~changing);
  for (unsigned left = changing; left != 0; left &= left - 1)
    state.recorder.set(kMaterial0 + std::countr_zero(left), value[0], value[1], value[2], value[3]);
  return true;
}

SlotMask slotsToSet(const RasterContext &context) {
  const ContextState &state = *context.software;
  return state.recorder.touched() & ~slotsOfMaterials(state.materials.given);
}

} // namespace arbiter::state
