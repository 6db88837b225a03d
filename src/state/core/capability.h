#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/core/context_hot.h"
#include "state/mirror/dirty_bits.h"
#include "state/objects/target.h"

namespace arbiter::state {

/// Who handles Enable and Disable of a capability.
enum class Capability : std::uint8_t {
  Host,              ///< the host alone
  ProgramTarget,     ///< the layer, if it offers the target
  FixedFunction,     ///< the host; selects the variant of an ATI shader (fixed_function.h)
  ClipPlane,         ///< the host; selects the variant of a vertex program (clip_planes.h)
  EvaluatorMap,      ///< the layer, if it offers NV_vertex_program
  PerStageConstants, ///< the layer, if it offers NV_register_combiners2
  Imaging,           ///< the layer, if it implements ARB_imaging
  PointSprite,       ///< the host; selects the variant that draws points (variants/point_sprites.h)
};

/// A row of the table of capabilities. Its eight bytes are a scale that x86 can index with.
struct CapabilityRow {
  GLenum cap = 0;
  Capability capability : 8 = Capability::Host;
  std::uint32_t dirty : 24 = kAllDirty; ///< groups that the mirror must query again

  static constexpr std::uint32_t kAllDirty = 0xFFFFFF;
};
static_assert(sizeof(CapabilityRow) == 8 && dirty::kGroups <= 24);

namespace detail {

using namespace dirty;

/// A program target's enable makes no group dirty: a draw checks it by itself.
inline constexpr CapabilityRow kCapabilities[] = {
    {infoOf(Target::Fragment).name, Capability::ProgramTarget, 0},
    {infoOf(Target::Vertex).name, Capability::ProgramTarget, 0},
    {infoOf(Target::AtiText).name, Capability::ProgramTarget, 0},
    {infoOf(Target::AtiApi).name, Capability::ProgramTarget, 0},
    {infoOf(Target::Combiners).name, Capability::ProgramTarget, 0},
    {infoOf(Target::TextureShaders).name, Capability::ProgramTarget, 0},
    {infoOf(Target::VertexShader).name, Capability::ProgramTarget, 0},
    {GL_FRAGMENT_PROGRAM_NV, Capability::ProgramTarget, 0},
    {GL_PER_STAGE_CONSTANTS_NV, Capability::PerStageConstants, 0},
    {GL_COLOR_TABLE, Capability::Imaging, 0},
    {GL_POST_CONVOLUTION_COLOR_TABLE, Capability::Imaging, 0},
    {GL_POST_COLOR_MATRIX_COLOR_TABLE, Capability::Imaging, 0},
    {GL_CONVOLUTION_1D, Capability::Imaging, 0},
    {GL_CONVOLUTION_2D, Capability::Imaging, 0},
    {GL_SEPARABLE_2D, Capability::Imaging, 0},
    {GL_HISTOGRAM, Capability::Imaging, 0},
    {GL_MINMAX, Capability::Imaging, 0},
    {GL_FOG, Capability::FixedFunction, kFog | kLighting},
    {GL_LIGHTING, Capability::FixedFunction, kLighting},
    {GL_COLOR_SUM, Capability::FixedFunction, kFog | kLighting},
    {GL_TEXTURE_1D, Capability::FixedFunction, kTextureBindings},
    {GL_TEXTURE_2D, Capability::FixedFunction, kTextureBindings},
    {GL_TEXTURE_3D, Capability::FixedFunction, kTextureBindings},
    {GL_TEXTURE_CUBE_MAP, Capability::FixedFunction, kTextureBindings},
    {GL_TEXTURE_RECTANGLE, Capability::FixedFunction, kTextureBindings},
    {GL_CLIP_PLANE0, Capability::ClipPlane, kTransform}, // CLIP_DISTANCEi has the same values
    {GL_CLIP_PLANE1, Capability::ClipPlane, kTransform},
    {GL_CLIP_PLANE2, Capability::ClipPlane, kTransform},
    {GL_CLIP_PLANE3, Capability::ClipPlane, kTransform},
    {GL_CLIP_PLANE4, Capability::ClipPlane, kTransform},
    {GL_CLIP_PLANE5, Capability::ClipPlane, kTransform},
    {GL_CLIP_DISTANCE6, Capability::ClipPlane, kTransform},
    {GL_CLIP_DISTANCE7, Capability::ClipPlane, kTransform},
    {GL_ALPHA_TEST, Capability::Host, kPixelOps},
    {GL_BLEND, Capability::Host, kPixelOps},
    {GL_DEPTH_TEST, Capability::Host, kPixelOps},
    {GL_STENCIL_TEST, Capability::Host, kPixelOps},
    {GL_COLOR_LOGIC_OP, Capability::Host, kPixelOps},
    {GL_DITHER, Capability::Host, kPixelOps},
    {GL_MULTISAMPLE, Capability::Host, kPixelOps},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, Capability::Host, kPixelOps},
    {GL_SAMPLE_ALPHA_TO_ONE, Capability::Host, kPixelOps},
    {GL_SAMPLE_COVERAGE, Capability::Host, kPixelOps},
    {GL_STENCIL_TEST_TWO_SIDE_EXT, Capability::Host, kPixelOps},
    {GL_DEPTH_BOUNDS_TEST_EXT, Capability::Host, kPixelOps},
    {GL_SCISSOR_TEST, Capability::Host, kViewport},
    {GL_CULL_FACE, Capability::Host, kRaster},
    {GL_LINE_SMOOTH, Capability::Host, kRaster},
    {GL_LINE_STIPPLE, Capability::Host, kRaster},
    {GL_POINT_SMOOTH, Capability::Host, kRaster},
    {GL_POLYGON_SMOOTH, Capability::Host, kRaster},
    {GL_POLYGON_STIPPLE, Capability::Host, kRaster},
    {GL_POLYGON_OFFSET_FILL, Capability::Host, kRaster},
    {GL_POLYGON_OFFSET_LINE, Capability::Host, kRaster},
    {GL_POLYGON_OFFSET_POINT, Capability::Host, kRaster},
    {GL_DEPTH_CLAMP, Capability::Host, kRaster},
    {GL_VERTEX_PROGRAM_POINT_SIZE, Capability::Host, kRaster | kTexGen},
    {GL_VERTEX_PROGRAM_TWO_SIDE, Capability::Host, kRaster | kLighting},
    {GL_POINT_SPRITE, Capability::PointSprite, kRaster | kTexGen},
    {GL_TEXTURE_GEN_S, Capability::Host, kTexGen},
    {GL_TEXTURE_GEN_T, Capability::Host, kTexGen},
    {GL_TEXTURE_GEN_R, Capability::Host, kTexGen},
    {GL_TEXTURE_GEN_Q, Capability::Host, kTexGen},
    {GL_COLOR_MATERIAL, Capability::Host, kLighting},
    {GL_LIGHT0, Capability::Host, kLighting},
    {GL_LIGHT1, Capability::Host, kLighting},
    {GL_LIGHT2, Capability::Host, kLighting},
    {GL_LIGHT3, Capability::Host, kLighting},
    {GL_LIGHT4, Capability::Host, kLighting},
    {GL_LIGHT5, Capability::Host, kLighting},
    {GL_LIGHT6, Capability::Host, kLighting},
    {GL_LIGHT7, Capability::Host, kLighting},
    {GL_NORMALIZE, Capability::Host, kTransform},
    {GL_RESCALE_NORMAL, Capability::Host, kTransform},
};

inline constexpr unsigned kSlotBits = 9;
constexpr unsigned slotOf(GLenum cap, std::uint32_t factor) {
  return (cap * factor) >> (32 - kSlotBits);
}

/// True if the factor gives two capabilities the same slot. Ends at the first such pair, as
/// compilers limit the steps of a constant expression.
constexpr bool clashes(std::uint32_t factor) {
  bool taken[1u << kSlotBits] = {};
  for (const CapabilityRow &row : kCapabilities) {
    bool &place = taken[slotOf(row.cap, factor)];
    if (place)
      return true;
    place = true;
  }
  return false;
}
/// Returns a hash factor, found at compile time, that gives each capability its own slot.
constexpr std::uint32_t perfectFactor() {
  std::uint32_t factor = 0x9E3779B1u;
  while (clashes(factor))
    factor += 2;
  return factor;
}
inline constexpr std::uint32_t kFactor = perfectFactor();

/// Returns the hash table: each row in its slot. The empty slots match no capability.
constexpr std::array<CapabilityRow, 1u << kSlotBits> placed() {
  std::array<CapabilityRow, 1u << kSlotBits> rows{};
  for (const CapabilityRow &row : kCapabilities)
    rows[slotOf(row.cap, kFactor)] = row;
  return rows;
}
inline constexpr auto kPlaced = placed();
inline constexpr CapabilityRow kOther{};
inline constexpr CapabilityRow kMap{0, Capability::EvaluatorMap, 0};

/// Returns the row of a capability outside the table. The 32 evaluator maps have consecutive values
/// and are rarely enabled, so they share one row.
constexpr const CapabilityRow &rowOfOther(GLenum cap) {
  return cap - GL_MAP1_VERTEX_ATTRIB0_4_NV < 32u ? kMap : kOther;
}

} // namespace detail

/// Returns the row of a capability, in one lookup: every Enable and Disable calls this, and most
/// are the host's alone. A capability outside the table makes all groups dirty.
[[nodiscard]] constexpr const CapabilityRow &rowOfCapability(GLenum cap) {
  const CapabilityRow &row = detail::kPlaced[detail::slotOf(cap, detail::kFactor)];
  if (row.cap != cap) [[unlikely]]
    return detail::rowOfOther(cap);
  return row;
}

/// Marks the groups that an Enable or Disable of the row's capability changes. They mostly are
/// dirty already; the test saves a store, which would stall on the one before.
inline void noteDirty(ContextHot &hot, const CapabilityRow &row) {
  if (row.dirty & ~hot.dirty)
    hot.dirty |= row.dirty;
}

} // namespace arbiter::state
