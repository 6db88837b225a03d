#include "state/report/refusals.h"

#include <atomic>
#include <cstdlib>
#include <map>
#include <mutex>

#include "state/identity/active_profile.h"
#include "util/hash.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

constexpr std::uint64_t kMaxLines = 8; ///< lines in the log; further refusals are counted
constexpr std::size_t kMaxKept = 4096; ///< texts that are remembered

struct KnownRefusals {
  std::mutex mutex;
  std::map<std::string, Refusal> known; ///< by target and hash
};

/// Returns the remembered refusals. Never freed: contexts may load programs after static
/// destructors began.
KnownRefusals &knownRefusals() {
  static KnownRefusals *const s_known = new KnownRefusals;
  return *s_known;
}

std::atomic<std::uint64_t> g_texts{0};

void sayRest() {
  const std::uint64_t texts = refusedTexts();
  if (texts > kMaxLines)
    logWarn("state", "and %llu more programs were refused by the profile %s alone",
            static_cast<unsigned long long>(texts - kMaxLines), activeProfile().name.c_str());
}

void say(const char *target, const Refusal &refusal, std::uint64_t before) {
  if (before == kMaxLines) {
    logWarn("state", "more programs are refused by the profile %s; --stats FILE names them all",
            activeProfile().name.c_str());
    std::atexit(sayRest); // if it cannot be registered, the statistics still have the number
  }
  if (before < kMaxLines)
    logWarn("state", "a %s program is refused by the profile %s alone: %s; arbiter run %s loads it",
            target, activeProfile().name.c_str(), refusal.reason.c_str(), refusal.remedy());
}

} // namespace

const char *Refusal::remedy() const {
  return byReport ? "--limits report or --profile host" : "--profile host";
}

Refusal noteRefusal(const char *target, std::string_view text,
                    const std::function<Refusal()> &look) {
  KnownRefusals &r = knownRefusals();
  const std::string key = target + toHex(hashBytes(text));
  const std::lock_guard lock(r.mutex);
  if (const auto known = r.known.find(key); known != r.known.end())
    return known->second;
  Refusal refusal = look();
  if (r.known.size() < kMaxKept)
    r.known.emplace(key, refusal);
  if (!refusal.reason.empty())
    say(target, refusal, g_texts.fetch_add(1, std::memory_order_relaxed));
  return refusal;
}

std::uint64_t refusedTexts() { return g_texts.load(std::memory_order_relaxed); }

} // namespace arbiter::state
