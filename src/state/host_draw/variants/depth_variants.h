#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/host_draw/variants/forms.h"

namespace arbiter::state {

/// The forms of a fragment program that is linked to a vertex shader of GLSL 1.30, beside which
/// Mesa takes DEPTH_TEXTURE_MODE ALPHA for INTENSITY: each has it in its text for some image units.
class DepthVariants {
public:
  DepthVariants(fp::GlslHost host, fp::Numerics numerics) : m_host(host), m_numerics(numerics) {}

  /// The form of `whole`, which this is the one of; `whole` itself without such units.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> of(const CompiledProgram &whole,
                                                          std::uint32_t alphaDepths) const;
  [[nodiscard]] std::vector<std::shared_ptr<const CompiledProgram>> all() const {
    return m_forms.all();
  }

private:
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  Forms<std::uint32_t> m_forms;
};

} // namespace arbiter::state
