#include "state/core/application_identity.h"

#include <atomic>
#include <string>

#include "state/core/core_context.h"
#include "state/identity/active_profile.h"
#include "state/identity/identity.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Logs once which extensions ARBITER_EXTENSIONS asks for in vain.
void sayAbsent(const Identity &identity) {
  static std::atomic<bool> s_said;
  if (identity.absent.empty() || s_said.exchange(true))
    return;
  for (const std::string &name : identity.absent)
    logError("state",
             "ARBITER_EXTENSIONS: %s=on: neither the host nor Arbiter under the profile %s "
             "implements it; it is not announced",
             name.c_str(), activeProfile().name.c_str());
}

} // namespace

const Identity &applicationIdentity(CoreContext &context) {
  if (!context.identity) {
    context.identity = &internIdentity(
        makeIdentity(context.caps, context.caps.obstacle() == nullptr, identityRules()));
    logInfo("state", "context %u: %zu extensions are announced", context.serial,
            context.identity->extensions.names.size());
    sayAbsent(*context.identity);
  }
  return *context.identity;
}

} // namespace arbiter::state
