#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/era/point_sprites.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// The variants of a fragment program linked with a vertex shader of GLSL 1.30, with which Mesa
/// takes DEPTH_TEXTURE_MODE ALPHA for INTENSITY. Each variant applies the mode itself for some
/// image units. There are also variants for point sprites of NV_point_sprite, each again with such
/// variants.
class DepthVariants {
public:
  DepthVariants(fp::GlslHost host, fp::Numerics numerics) : m_host(host), m_numerics(numerics) {}

  /// Returns the variant of `whole`, the program that this object belongs to, for some units;
  /// `whole` itself if there are none.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> of(const CompiledProgram &whole,
                                                          std::uint32_t alphaDepths) const;
  /// Returns the variant for point sprites; `whole` itself if no unit is replaced.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> ofSprites(const CompiledProgram &whole,
                                                                 const SpriteForm &sprites) const;
  [[nodiscard]] std::vector<std::shared_ptr<const CompiledProgram>> all() const {
    std::vector<std::shared_ptr<const CompiledProgram>> forms = m_forms.all();
    for (auto &form : m_sprites.all())
      forms.push_back(std::move(form));
    return forms;
  }

private:
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  Forms<std::uint32_t> m_forms;
  Forms<SpriteForm> m_sprites;
};

} // namespace arbiter::state
