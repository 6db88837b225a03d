#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>

#include "fp_compiler/ir/interface.h"
#include "state/mirror/mirror.h"
#include "state/raster_draw/fixed_function/fixed_programs.h"

/// Writes fixed-function vertex processing (OpenGL 1.4, chapter 2) as programs of
/// Language::ArbVertex, one for each state that needs other code.
namespace arbiter::state {

/// The first output for clip distances. Distances to planes 0 to 3 are the components of
/// result.texcoord[8], those to planes 4 to 7 of result.texcoord[9]. No application has these
/// coordinates.
inline constexpr int kClipDistanceOutput = 8;

/// The vertex results that a draw needs beside the position.
struct VertexNeeds {
  std::uint8_t texCoords = 0; ///< one bit for each unit
  bool primary = false, secondary = false, fogCoord = false;
  bool pointSize = false; ///< true if the primitives are points
  /// Material parts that are vertex attributes (attributes.h), one bit for each.
  std::uint8_t frontMaterials = 0, backMaterials = 0;
  bool operator==(const VertexNeeds &) const = default;
};

/// All state that the code depends on. It consists of plain bytes, and is compared and hashed as
/// such.
struct FixedVertexKey {
  VertexNeeds needs;
  std::uint8_t clipPlanes = 0;
  std::uint8_t textureMatrix = 0;
  FogFrom fogFrom = FogFrom::Coordinate;
  std::uint8_t pointAttenuation = 0;
  std::uint8_t lighting = 0, twoSided = 0, localViewer = 0, separateSpecular = 0;
  ColorClamp clampColors = ColorClamp::None;
  std::uint8_t colorMaterialFace = 0, colorMaterialParts = 0;
  std::uint8_t normalize = 0, rescale = 0;
  std::uint8_t lights = 0, positional = 0, spots = 0, attenuated = 0;
  std::array<std::array<std::uint8_t, 4>, 8> texGen{}; ///< 0: off, else 1 + TexGenMode
  bool operator==(const FixedVertexKey &) const = default;
};
/// Returns the key, without what the needs make irrelevant, so that few programs suffice.
[[nodiscard]] FixedVertexKey fixedVertexKey(const VertexState &state, const VertexNeeds &needs);

/// Makes the program of a key. It writes the outputs that are needed, of: the position,
/// FrontPrimary, BackPrimary if both sides are lit, the secondary colours, FogCoord, PointSize,
/// TexCoord, and clip distances.
[[nodiscard]] fp::ir::Program makeFixedVertexProgram(const FixedVertexKey &key);

/// Extends an application's vertex program with parts of fixed function: the position if it has
/// ARB_position_invariant, clip distances, and clamping of colours to [0,1]
/// (VertexState::clampColors).
[[nodiscard]] fp::ir::Program withFixedPosition(fp::ir::Program program, std::uint8_t clipPlanes,
                                                ColorClamp clamp);

/// Keeps the results of withFixedPosition(), for applications that alternate between programs.
class ExtendedPrograms {
public:
  [[nodiscard]] const std::shared_ptr<const fp::ir::Program> &
  get(const std::shared_ptr<const fp::ir::Program> &program, std::uint8_t clipPlanes,
      ColorClamp clamp);

private:
  struct Key {
    const fp::ir::Program *program;
    std::uint8_t clipPlanes;
    ColorClamp clamp;
    bool operator==(const Key &) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key &key) const {
      return std::hash<const void *>()(key.program) * 31 +
             (std::size_t(key.clipPlanes) << 2 | std::size_t(key.clamp));
    }
  };
  struct Entry {
    std::shared_ptr<const fp::ir::Program> program, extended;
  };
  void sweep();
  std::unordered_map<Key, Entry, Hash> m_programs;
  std::size_t m_sweepAt = 64;
};

/// The programs in use, and the choice among them.
class FixedVertexPrograms {
public:
  /// Returns the program for mirror.vertex. It only takes a few compares if neither that nor the
  /// needs have changed.
  [[nodiscard]] const std::shared_ptr<const fp::ir::Program> &get(const VertexState &state,
                                                                  const VertexNeeds &needs);

private:
  FixedPrograms<FixedVertexKey> m_programs;
  const std::shared_ptr<const fp::ir::Program> *m_last = nullptr;
  std::uint32_t m_lastVersion = 0;
  VertexNeeds m_lastNeeds;
};

} // namespace arbiter::state
