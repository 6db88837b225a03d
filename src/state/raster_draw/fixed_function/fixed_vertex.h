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

/// Fixed-function vertex processing (OpenGL 1.4, chapter 2) as programs of Language::ArbVertex, one
/// for each state that differs in code.
namespace arbiter::state::software {

/// User clip planes: distances to planes 0 to 3 are the components of result.texcoord[8], those to
/// planes 4 to 7 of result.texcoord[9]: coordinates that no application has.
inline constexpr int kClipDistanceOutput = 8;

/// What a draw wants of its vertices beside the position.
struct VertexNeeds {
  std::uint8_t texCoords = 0; ///< one bit each
  bool primary = false, secondary = false, fogCoord = false;
  bool pointSize = false; ///< the primitives are points
  /// Parts of the materials that are the vertex's own (attributes.h), one bit each.
  std::uint8_t frontMaterials = 0, backMaterials = 0;
  bool operator==(const VertexNeeds &) const = default;
};

/// All that the code depends on. Plain bytes: compare and hash as such.
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
  std::array<std::array<std::uint8_t, 4>, 8> texGen{}; ///< 0 off, else 1 + TexGenMode
  bool operator==(const FixedVertexKey &) const = default;
};
/// Without what the needs make irrelevant, so that few programs serve.
[[nodiscard]] FixedVertexKey fixedVertexKey(const VertexState &state, const VertexNeeds &needs);

/// Outputs: the position; FrontPrimary and, where lit on both sides, BackPrimary; the secondaries;
/// FogCoord; PointSize; TexCoord; the clip distances: those that are needed.
[[nodiscard]] fp::ir::Program makeFixedVertexProgram(const FixedVertexKey &key);

/// An application's vertex program with what fixed function adds: the position where it has
/// ARB_position_invariant, clip distances, colours clamped to [0,1] (VertexState::clampColors).
[[nodiscard]] fp::ir::Program withFixedPosition(fp::ir::Program program, std::uint8_t clipPlanes,
                                                ColorClamp clamp);

/// The programs that withFixedPosition() gave, so that an application that changes between programs
/// finds them again.
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

/// The programs made, and the choice among them.
class FixedVertexPrograms {
public:
  /// For mirror.vertex as it is now; a few compares where neither it nor the needs have changed.
  [[nodiscard]] const std::shared_ptr<const fp::ir::Program> &get(const VertexState &state,
                                                                  const VertexNeeds &needs);

private:
  FixedPrograms<FixedVertexKey> m_programs;
  const std::shared_ptr<const fp::ir::Program> *m_last = nullptr;
  std::uint32_t m_lastVersion = 0;
  VertexNeeds m_lastNeeds;
};

} // namespace arbiter::state::software
