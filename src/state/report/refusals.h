#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

/// Programs that the active profile refuses and the host's own limits would load: the application
/// draws without them, or not at all, and nobody would know why. Each text is named once in the
/// log, and counted.
namespace arbiter::state {

/// Why the profile alone refuses a text, and what would load it.
struct Refusal {
  std::string reason;    ///< "line 66: more than 64 ALU instructions"; empty: it is no such text
  bool byReport = false; ///< ARBITER_LIMITS=report loads it, too; the profile `host` always does

  /// Returns the options of `arbiter run` that load it: "--limits report or --profile host".
  [[nodiscard]] const char *remedy() const;
};

/// Notes a text that was refused, and says it in the log if it was not said yet.
/// \param target its word; \param look finds out why, and is not called for a text that is known
/// \returns an empty one where the host's limits do not load the text either
Refusal noteRefusal(const char *target, std::string_view text,
                    const std::function<Refusal()> &look);

/// How many such texts the process has loaded so far.
[[nodiscard]] std::uint64_t refusedTexts();

} // namespace arbiter::state
