#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/emit.h"

namespace arbiter::state {

struct DrawContext;
struct LinkedProgram;

/// Switches off texture comparison for plain samplers. Without a SHADOW target,
/// TEXTURE_COMPARE_MODE must count as NONE (AFP 4051-4057), but a host's plain samplers still
/// compare. For each unit in use whose texture compares, it binds a sampler object with the
/// texture's parameters and compare mode NONE.
class SamplerOverride {
public:
  static constexpr int kMaxUnits = 32;

  /// Overrides the plain samplers of a linked program where needed. Called for each draw while any
  /// texture may compare.
  void apply(DrawContext &context, const LinkedProgram &linkedProgram);
  /// Restores the application's sampler bindings.
  void release(DrawContext &context);
  [[nodiscard]] bool active() const { return m_active != 0; }
  [[nodiscard]] bool owns(GLuint sampler) const;
  /// Empties the object without calling the host, and returns the names of its samplers.
  [[nodiscard]] std::vector<GLuint> abandon();

private:
  void applyUnit(DrawContext &context, const fp::GlslSampler &sampler);

  struct Unit {
    GLuint uncompared = 0;  ///< created at first use
    GLuint application = 0; ///< the application's binding while the override is bound
  };
  std::array<Unit, kMaxUnits> m_units{};
  std::uint32_t m_active = 0; ///< one bit for each unit
};

/// Restores the application's sampler bindings; the next draw overrides again.
void releaseSamplers(DrawContext &context);

} // namespace arbiter::state
