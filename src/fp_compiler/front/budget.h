#pragma once
#include <array>
#include <cstdint>

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
};
inline constexpr int kResourceCount = 7;

/// Counts a program's resources against the API limits (3.11.3.6), less the debits of a fog option
/// (3.11.4.5.1), and reports each resource once, where it is first exceeded.
class Budget {
public:
  /// No program has more of a resource than this, whatever the limits say: registers are numbered
  /// in 16 bits.
  static constexpr std::uint32_t kCeiling = 65535;

  Budget(const CompileOptions &options, Reporter &reporter);

  /// Takes what the fog option's own code needs out of the limits. Call before the first statement.
  void debitFog(ir::FogMode mode);
  /// Counts one unit. False if it is over kCeiling, so that the caller cannot number it.
  bool spend(Resource resource, Span where);
  [[nodiscard]] const ResourceCounts &counts() const { return m_counts; }

private:
  void report(Resource resource, Span where, std::uint32_t limit, bool ceiling);

  Reporter &m_reporter;
  LimitPolicy m_policy;
  ResourceCounts m_limits;
  bool m_refuseIndirections;
  ResourceCounts m_debits;
  ResourceCounts m_counts;
  std::array<bool, kResourceCount> m_reported{};
  std::array<bool, kResourceCount> m_ceilingReported{};
};

} // namespace arbiter::fp
