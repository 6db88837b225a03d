#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/era/point_sprites.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// The forms of a fragment program that is linked to a vertex shader of GLSL 1.30, beside which
/// Mesa takes DEPTH_TEXTURE_MODE ALPHA for INTENSITY: each has it in its text for some image units.
/// And those that points are drawn with as sprites of NV_point_sprite's, each with such forms.
class DepthVariants {
public:
  DepthVariants(fp::GlslHost host, fp::Numerics numerics) : m_host(host), m_numerics(numerics) {}

  /// The form of `whole`, which this is the one of; `whole` itself without such units.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> of(const CompiledProgram &whole,
                                                          std::uint32_t alphaDepths) const;
  /// The same for sprites; `whole` itself without units.
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
