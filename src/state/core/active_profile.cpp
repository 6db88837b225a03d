#include "state/core/active_profile.h"

#include "util/defaults/choice.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

const fp::hw::Profile &activeProfile() {
  static const fp::hw::Profile *const s_profile = [] {
    auto loaded = fp::hw::loadProfile(settings().profile);
    if (loaded)
      return static_cast<const fp::hw::Profile *>(
          new fp::hw::Profile(std::move(loaded).value())); // lives as long as the process
    const defaults::Choice *const choice = defaults::ownChoiceIfRead();
    const defaults::Setting *const from = choice ? choice->find(Env::Profile) : nullptr;
    logWarn("state", "%s%s; going on with profile %s",
            from && from->used ? (from->place() + ": ").c_str() : "",
            loaded.error().message.c_str(), std::string(fp::hw::kDefaultProfile).c_str());
    return fp::hw::findBuiltin(fp::hw::kDefaultProfile);
  }();
  return *s_profile;
}

fp::Numerics activeNumerics() {
  return fp::numericsNamed(settings().numerics).value_or(activeProfile().numerics);
}

std::string_view nameOf(fp::Numerics numerics) { return fp::kNumericsNames[std::size_t(numerics)]; }

} // namespace arbiter::state
