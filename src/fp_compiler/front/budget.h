#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "fp_compiler/compiler.h"
#include "fp_compiler/front/reporter.h"

namespace arbiter::fp {

enum class Resource : std::uint8_t {
  Instructions,
  AluInstructions,
  TexInstructions,
  TexIndirections,
  Temporaries,
  Parameters,
  Attribs,
  AddressRegisters,
};
inline constexpr int kResourceCount = 8;

/// Counts a program's resources against the API limits (ARB_fragment_program 3.11.3.6,
/// ARB_vertex_program 2.14.3.7), less what an option takes for its own code (3.11.4.5.1,
/// 2.14.4.5.1), and reports each resource once, where it is first exceeded.
class Budget {
public:
  /// No program has more of a resource than this, whatever the limits say: registers are numbered
  /// in 16 bits (address registers in eight).
  static constexpr std::uint32_t kCeiling = 65535;

  /// The limits and the policy of \p options. \p reporter gets what is exceeded: an error, or a
  /// warning where the policy lets the program load all the same.
  Budget(const CompileOptions &options, Reporter &reporter);

  /// Takes what the options' own code needs out of the limits. Call before the first statement.
  void debit(const ir::Options &options);
  /// Counts one unit. False if it is over the resource's ceiling, so that the caller cannot number
  /// it.
  bool spend(Resource resource, Span where);
  /// The program is read: reports what it has too much of and loads with all the same, which is a
  /// warning with the whole count.
  void finish();
  /// What was spent, beyond the limits too; without the debits.
  [[nodiscard]] const ResourceCounts &counts() const { return m_counts; }

private:
  [[nodiscard]] bool loads(Resource resource) const;
  [[nodiscard]] std::uint32_t limitOf(Resource resource) const;
  /// "4 texture indirections", with what an option takes of them.
  [[nodiscard]] std::string amount(Resource resource) const;
  void reportCeiling(Resource resource, Span where);

  Reporter &m_reporter;
  LimitPolicy m_policy;
  ResourceCounts m_limits;
  bool m_refuseIndirections;
  std::string m_card;
  ResourceCounts m_debits;
  const char *m_debitor = ""; ///< the option that m_debits are for
  ResourceCounts m_counts;
  /// Where each is first over its limit.
  std::array<std::optional<Span>, kResourceCount> m_over{};
  std::array<bool, kResourceCount> m_ceilingReported{};
};

} // namespace arbiter::fp
