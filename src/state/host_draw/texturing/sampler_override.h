#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/emit.h"

namespace arbiter::state {

class Context;
struct LinkedProgram;

/// Without a SHADOW target TEXTURE_COMPARE_MODE counts as NONE (AFP 4051-4057), while a host's
/// plain samplers still compare. Where a texture of a used unit compares, a sampler object of the
/// layer's that copies its parameters with compare NONE is bound for the draw.
class SamplerOverride {
public:
  static constexpr int kMaxUnits = 32;

  /// Checks the plain samplers of `linked program`. Called for each draw while any texture may
  /// compare.
  void apply(Context &context, const LinkedProgram &linkedProgram);
  /// Puts the application's sampler bindings back.
  void release(Context &context);
  [[nodiscard]] bool active() const { return m_active != 0; }
  [[nodiscard]] bool owns(GLuint sampler) const;
  /// Empties without touching the host; gives the sampler names.
  [[nodiscard]] std::vector<GLuint> abandon();

private:
  void applyUnit(Context &context, const fp::GlslSampler &sampler);

  struct Unit {
    GLuint uncompared = 0;  ///< made at first use
    GLuint application = 0; ///< its binding while the override is bound
  };
  std::array<Unit, kMaxUnits> m_units{};
  std::uint32_t m_active = 0; ///< one bit a unit
};

/// The host's sampler bindings become the application's again; the next draw looks.
void releaseSamplers(Context &context);

} // namespace arbiter::state
