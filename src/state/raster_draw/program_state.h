#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "state/mirror/dirty_bits.h"
#include "state/mirror/generation_counter.h"
#include "state/objects/program_object.h"

namespace arbiter::state {
class Context;
struct ProgramTarget;
} // namespace arbiter::state

namespace arbiter::state::software {

/// The values of a program's parameters, rows as machine code reads them
/// (FragmentData::parameters). One for each program and context.
class ProgramValues {
public:
  explicit ProgramValues(const fp::ir::Program &program);

  /// Brings the rows up to date: env and local ones where one of their target changed, state rows
  /// where their group did. `row` is the target that the program was loaded to, bound to the object
  /// that it is of; null for fixed function's. After refresh().
  /// True if a value changed.
  bool update(Context &context, const GenerationCounter &clock, const ProgramTarget *row);
  [[nodiscard]] const float (*data() const)[4] {
    return reinterpret_cast<const float(*)[4]>(m_values.data());
  }
  [[nodiscard]] std::size_t size() const { return m_values.size(); }
  [[nodiscard]] bool readsMaterials() const { return (m_groups & dirty::kMaterial) != 0; }

private:
  /// What env and local parameters were read at.
  struct Versions {
    std::uint64_t selections = 0;
    std::uint32_t object = 0, env = 0;
    bool operator==(const Versions &) const = default;
  };
  struct Indexed {
    std::uint16_t row;
    std::uint16_t index;
  };
  struct State {
    std::uint16_t row;
    std::uint32_t groups; ///< dirty bits that it depends on
    fp::ir::StateRef state;
  };
  bool updateParameters(const ProgramTarget &target);
  bool updateStates(Context &context, std::uint32_t groups);
  /// True if that is another value.
  bool set(std::size_t row, const Vec4 &value);

  std::vector<Vec4> m_values; ///< one at least
  std::vector<Indexed> m_env, m_local;
  std::vector<State> m_states;
  std::uint32_t m_groups = 0; ///< of all of m_states
  std::uint64_t m_seen = 0;
  Versions m_versions;
};

/// The dirty bits whose commands may change a row of state.
[[nodiscard]] std::uint32_t dirtyGroupsOf(const fp::ir::StateRef &state);

} // namespace arbiter::state::software
