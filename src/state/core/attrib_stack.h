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

/// Mirrors the host's attribute stack as far as our own state is in it: the enables are, in
/// GL_ENABLE_BIT (AFP 4642-4645), those of evaluators in GL_EVAL_BIT too (NV_vertex_program);
/// hints, in GL_HINT_BIT; those of register combiners and of texture shaders in GL_TEXTURE_BIT with
/// all of their state. Bindings and parameters are in no group.
class AttribStack {
public:
  struct Entry {
    bool hasEnables = false;
    std::uint8_t enabledTargets = 0;             ///< one bit a program target
    std::uint32_t dirty = software::dirty::kAll; ///< groups that the pop restores
    bool hasMaps = false;                        ///< of NV_vertex_program's evaluators
    std::uint32_t enabledMaps = 0;
    std::optional<Hints> hints;                        ///< of GL_HINT_BIT
    bool perStageConstants = false;                    ///< PER_STAGE_CONSTANTS_NV
    std::shared_ptr<const CombinerSettings> combiners; ///< null without GL_TEXTURE_BIT
    std::shared_ptr<const TextureShaderSettings>
        textureShaders;                                  ///< null as long as the context has none
    std::shared_ptr<const ComponentTransfers> transfers; ///< null without GL_PIXEL_MODE_BIT
    std::shared_ptr<const std::vector<SavedTextureRange>> textureRanges; ///< of GL_TEXTURE_BIT
    std::shared_ptr<const imaging::Settings> imaging; ///< once ARB_imaging was used
    bool hasPixelMode = false;                        ///< GL_PIXEL_MODE_BIT
    bool hasTextures = false;                         ///< GL_TEXTURE_BIT
    bool hasMatrixMode = false;                       ///< GL_TRANSFORM_BIT
    bool colorMatrix = false;                         ///< COLOR was the mode
    std::optional<GLenum> spriteMode;                 ///< POINT_SPRITE_R_MODE_NV, of GL_POINT_BIT
  };

  void setMaxDepth(std::size_t depth) {
    m_maxDepth = depth;
    m_entries.reserve(depth); // pushes then never allocate
  }

  /// False: the host's stack overflows, and so would the layer's.
  bool push(Entry entry) {
    if (m_entries.size() >= m_maxDepth)
      return false;
    m_entries.push_back(std::move(entry));
    return true;
  }
  /// False on underflow.
  bool pop(Entry &entry) {
    if (m_entries.empty())
      return false;
    entry = std::move(m_entries.back());
    m_entries.pop_back();
    return true;
  }

  /// Groups that the next pop restores.
  [[nodiscard]] std::uint32_t restores() const {
    return m_entries.empty() ? 0 : m_entries.back().dirty;
  }
  [[nodiscard]] std::size_t depth() const { return m_entries.size(); }
  /// After a host list moved the host's stack alone: entries that we did not see hold no enables.
  void resize(std::size_t depth) { m_entries.resize(depth < m_maxDepth ? depth : m_maxDepth); }

private:
  std::vector<Entry> m_entries;
  std::size_t m_maxDepth = 16;
};

} // namespace arbiter::state
