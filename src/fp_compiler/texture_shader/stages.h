#pragma once
#include <array>
#include <optional>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::texture_shader {

/// Emits the stages of an essential() state. Each unit's result is emitted on first use. finish()
/// emits side effects: culling and depth replacement.
class Stages {
public:
  Stages(ir::Builder &builder, const State &state) : m_builder(builder), m_state(state) {}

  /// Returns the texture unit RGBA result (tables 3.D and 3.E), or nothing if it is (0, 0, 0, 0).
  [[nodiscard]] std::optional<ir::Source> color(int unit);
  /// Returns the base internal format of the unit's colour for texture environments. None means
  /// that the environment does not apply.
  [[nodiscard]] Base environmentBase(int unit) const;
  /// Emits all stages that discard fragments or replace their depth, in order.
  void finish();

private:
  [[nodiscard]] const Stage &stage(int unit) const { return m_state.stages[std::size_t(unit)]; }
  [[nodiscard]] const OperationInfo &info(int unit) const { return infoOf(stage(unit).operation); }
  [[nodiscard]] ir::Source coordinates(int unit) {
    return m_builder.attribute(ir::AttributeKind::TexCoord, unit);
  }
  /// Returns the shader result: a colour, (HI, LO), or (ds, dt, magnitude, intensity).
  ir::Source result(int unit);
  ir::Source shade(int unit);
  ir::Source sample(int unit, ir::Opcode opcode, const ir::Source &at);
  ir::Source moved(int unit);
  [[nodiscard]] std::uint32_t bumping(int unit) const;
  ir::Source bumped(int unit);
  ir::Source dependent(int unit);
  /// Returns the dot product of the stage in every component.
  ir::Source dot(int unit);
  ir::Source product(int unit);
  ir::Source products(int first, int count);
  ir::Source reflected(int unit);
  ir::Source scaled(int unit);
  void cull(int unit);
  void replaceDepth(int unit);

  ir::Builder &m_builder;
  const State &m_state;
  std::array<std::optional<ir::Source>, kUnits> m_results, m_dots, m_scaled;
};

} // namespace arbiter::fp::texture_shader
