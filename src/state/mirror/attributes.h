#pragma once
#include <array>
#include <cstdint>

#include "fp_compiler/ir/interface.h"

/// Vertex attributes, numbered in one sequence whatever command or array sets them.
namespace arbiter::state {

enum Slot : std::uint8_t {
  kPosition = 0,
  kNormal = 1,
  kColor = 2,
  kSecondary = 3,
  kFogCoord = 4,
  kEdgeFlag = 5, ///< x is 0 or 1
  kTexCoord0 = 8,
  kGeneric0 = 16, ///< generic 0 is the position, so this slot stays empty
  /// Parts of the front and then of the back material, where they differ between vertices
  /// (immediate/primitive_materials.h). They have no arrays, and the mirror has no values for them.
  kMaterial0 = 32,
  kSlots = 42,
};
/// Texture coordinates, one bit per slot.
inline constexpr std::uint32_t kTexCoords = 0xFFu << kTexCoord0;
/// One bit per slot. The slots of arrays and current values fit the lower half.
using SlotMask = std::uint64_t;

/// Emission, ambient, diffuse, specular, shininess, in this order.
inline constexpr int kMaterialParts = 5;
/// Parts of both materials, one bit each, the front's first.
using MaterialMask = std::uint16_t;
inline constexpr MaterialMask kFrontMaterial = (1u << kMaterialParts) - 1;
inline constexpr MaterialMask kAllMaterials = (1u << 2 * kMaterialParts) - 1;
[[nodiscard]] constexpr MaterialMask materialsIn(SlotMask slots) {
  return MaterialMask(slots >> kMaterial0);
}
[[nodiscard]] constexpr SlotMask slotsOfMaterials(MaterialMask materials) {
  return SlotMask(materials) << kMaterial0;
}
/// Returns a material part's index as a vertex program's generic attribute. It is above those that
/// applications have.
[[nodiscard]] constexpr int materialAttribute(bool back, int part) {
  return kMaterial0 - kGeneric0 + (back ? kMaterialParts : 0) + part;
}

/// Returns the slot of an attribute of a vertex program or of fixed function.
[[nodiscard]] constexpr int slotOf(const fp::ir::Attribute &attribute) {
  using Kind = fp::ir::AttributeKind;
  switch (attribute.kind) {
  case Kind::ColorPrimary:
    return kColor;
  case Kind::ColorSecondary:
    return kSecondary;
  case Kind::TexCoord:
    return kTexCoord0 + attribute.index;
  case Kind::FogCoord:
    return kFogCoord;
  case Kind::Position:
    return kPosition;
  case Kind::Normal:
    return kNormal;
  case Kind::Generic:
    return attribute.index == 0 ? int(kPosition) : kGeneric0 + attribute.index;
  case Kind::Facing:
    break; // only fragments have it
  }
  return kPosition;
}

using CurrentValues = std::array<std::array<float, 4>, kSlots>;

/// The source of a draw's vertices: per slot an array, or the current value (null).
struct VertexSource {
  struct Array {
    const void *base = nullptr; ///< address of vertex 0, in client memory, a mapped buffer or a
                                ///< recording
    std::uint32_t stride = 0;   ///< bytes, never 0
    std::uint32_t type = 0;     ///< GL_FLOAT, GL_UNSIGNED_BYTE ..
    std::uint8_t components = 4;
    bool normalized = false;
    bool bgra = false;
  };
  std::array<Array, kSlots> arrays;
  /// Signed normalised numbers are c / (2^(b-1) - 1), as in OpenGL 4.2; else (2c+1)/(2^b-1).
  bool symmetric = false;
  /// The vertices come from a display list. The host splits its quads from the second corner to the
  /// fourth.
  bool fromList = false;
  std::uint32_t count = 0; ///< vertices that may be read; 0: those that the indices name
};

/// Returns the bytes of one element of an array; 0 if the type is unknown.
[[nodiscard]] std::uint32_t elementBytes(const VertexSource::Array &array);

} // namespace arbiter::state
