#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <GL/gl.h>

#include "state/mirror/dirty_bits.h"
#include "state/objects/hints.h"

namespace arbiter::state {

namespace imaging {
struct Settings;
}
struct CombinerSettings;
struct ComponentTransfers;
struct SavedTextureRange;
struct TextureShaderSettings;

/// Mirrors the host's attribute stack for the state that the layer keeps itself. GL_ENABLE_BIT
/// saves the enables of program targets (AFP 4642-4645), GL_EVAL_BIT those of evaluators
/// (NV_vertex_program), GL_HINT_BIT the hints. GL_TEXTURE_BIT saves all state of register combiners
/// and texture shaders. No group holds bindings and parameters.
class AttribStack {
public:
  struct Entry {
    bool hasEnables = false;
    std::uint8_t enabledTargets = 0;   ///< one bit per program target
    std::uint32_t dirty = dirty::kAll; ///< groups that the pop restores
    bool hasMaps = false;              ///< `enabledMaps` of NV_vertex_program is saved
    std::uint32_t enabledMaps = 0;
    std::optional<Hints> hints;                        ///< saved by GL_HINT_BIT
    bool perStageConstants = false;                    ///< PER_STAGE_CONSTANTS_NV
    std::shared_ptr<const CombinerSettings> combiners; ///< null without GL_TEXTURE_BIT
    std::shared_ptr<const TextureShaderSettings>
        textureShaders;                                  ///< null as long as the context has none
    std::shared_ptr<const ComponentTransfers> transfers; ///< null without GL_PIXEL_MODE_BIT
    std::shared_ptr<const std::vector<SavedTextureRange>> textureRanges; ///< saved by
                                                                         ///< GL_TEXTURE_BIT
    std::shared_ptr<const imaging::Settings> imaging; ///< null before ARB_imaging is used
    bool hasPixelMode = false;                        ///< GL_PIXEL_MODE_BIT
    bool hasTextures = false;                         ///< GL_TEXTURE_BIT
    bool hasMatrixMode = false;                       ///< GL_TRANSFORM_BIT
    bool colorMatrix = false;                         ///< the matrix mode was COLOR
    std::optional<GLenum> spriteMode;                 ///< POINT_SPRITE_R_MODE_NV, saved by
                                                      ///< GL_POINT_BIT
  };

  void setMaxDepth(std::size_t depth) {
    m_maxDepth = depth;
    m_entries.reserve(depth); // pushes then never allocate
  }

  /// Saves an entry. Returns false if the host's stack overflows, as this one would.
  bool push(Entry entry) {
    if (m_entries.size() >= m_maxDepth)
      return false;
    m_entries.push_back(std::move(entry));
    return true;
  }
  /// Restores the last entry. Returns false on underflow.
  bool pop(Entry &entry) {
    if (m_entries.empty())
      return false;
    entry = std::move(m_entries.back());
    m_entries.pop_back();
    return true;
  }

  /// Returns the groups of state that the next pop restores.
  [[nodiscard]] std::uint32_t restores() const {
    return m_entries.empty() ? 0 : m_entries.back().dirty;
  }
  [[nodiscard]] std::size_t depth() const { return m_entries.size(); }
  /// Follows the host's stack after a host list moved it. Entries that the layer did not see being
  /// pushed hold no enables.
  void resize(std::size_t depth) { m_entries.resize(depth < m_maxDepth ? depth : m_maxDepth); }

private:
  std::vector<Entry> m_entries;
  std::size_t m_maxDepth = 16;
};

} // namespace arbiter::state
