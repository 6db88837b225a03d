#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "state/mirror/dirty_bits.h"
#include "state/mirror/generation_counter.h"
#include "state/objects/program_object.h"

namespace arbiter::state {
struct RasterContext;
struct ProgramTarget;
} // namespace arbiter::state

namespace arbiter::state {

/// The values of a program's parameters, in the rows that machine code reads
/// (FragmentData::parameters). There is one for each program and context.
class ProgramValues {
public:
  explicit ProgramValues(const fp::ir::Program &program);

  /// Updates the rows. Env and local parameters are read if their target changed, and state rows if
  /// their group did. `row` is the program target with the program's object bound, or null for
  /// fixed function. Call it after refresh(). Returns true if a value changed.
  bool update(RasterContext &context, const GenerationCounter &clock, const ProgramTarget *row);
  [[nodiscard]] const float (*data() const)[4] {
    return reinterpret_cast<const float(*)[4]>(m_values.data());
  }
  [[nodiscard]] std::size_t size() const { return m_values.size(); }
  [[nodiscard]] bool readsMaterials() const { return (m_groups & dirty::kMaterial) != 0; }

private:
  /// The versions at which env and local parameters were read.
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
  bool updateStates(RasterContext &context, std::uint32_t groups);
  /// Sets a row. Returns true if its value changed.
  bool set(std::size_t row, const Vec4 &value);

  std::vector<Vec4> m_values; ///< at least one
  std::vector<Indexed> m_env, m_local;
  std::vector<State> m_states;
  std::uint32_t m_groups = 0; ///< union over m_states
  std::uint64_t m_seen = 0;
  Versions m_versions;
};

/// Returns the dirty bits of the commands that may change a row of state.
[[nodiscard]] std::uint32_t dirtyGroupsOf(const fp::ir::StateRef &state);

} // namespace arbiter::state
