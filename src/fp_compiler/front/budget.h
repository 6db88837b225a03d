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
/// ARB_vertex_program 2.14.3.7). The limits are reduced by what an option's own code takes
/// (3.11.4.5.1, 2.14.4.5.1). Each resource is reported once, where it first exceeds its limit.
class Budget {
public:
  /// The most of a resource in any program, whatever the limits: registers are numbered in 16 bits
  /// (address registers in eight).
  static constexpr std::uint32_t kCeiling = 65535;

  /// Uses the limits and the policy of \p options. An excess is reported to \p reporter as an
  /// error, or as a warning if the policy lets the program load.
  Budget(const CompileOptions &options, Reporter &reporter);

  /// Reserves what the options' own code needs. Call before the first statement.
  void debit(const ir::Options &options);
  /// Counts one unit. Returns false if it is over the ceiling, so that the caller cannot number it.
  bool spend(Resource resource, Span where);
  /// Ends the count. Reports what exceeds a limit and still loads: a warning with the whole count.
  void finish();
  /// Returns the counts, including what exceeds the limits, and without the debits.
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
  /// The place at which each resource first exceeds its limit.
  std::array<std::optional<Span>, kResourceCount> m_over{};
  std::array<bool, kResourceCount> m_ceilingReported{};
};

} // namespace arbiter::fp
