#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

/// Programs that the active profile refuses but the host's own limits allow. The application draws
/// without them, or not at all, and would not show why. Each text is logged once and counted.
namespace arbiter::state {

/// Why only the profile refuses a text, and what would load it.
struct Refusal {
  std::string reason;    ///< "line 66: more than 64 ALU instructions"; empty: the profile is not
                         ///< the reason
  bool byReport = false; ///< ARBITER_LIMITS=report loads it too; the profile `host` always does

  /// Returns the options of `arbiter run` that load it: "--limits report or --profile host".
  [[nodiscard]] const char *remedy() const;
};

/// Notes a refused text, and logs it if it is new.
/// \param target the target's word
/// \param look finds out why; not called for a known text
/// \returns an empty refusal if the host's limits do not allow the text either
Refusal noteRefusal(const char *target, std::string_view text,
                    const std::function<Refusal()> &look);

/// Returns how many such texts the process has loaded so far.
[[nodiscard]] std::uint64_t refusedTexts();

} // namespace arbiter::state
