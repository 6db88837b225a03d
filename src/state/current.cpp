#include "state/context.h"
#include "state/lifecycle.h"

namespace arbiter::state {

namespace {

/// The null context, which is never destroyed: entry points may run in other libraries'
/// destructors.
struct NullHolder {
  union {
    Context context;
  };
  constexpr NullHolder() : context(Context::NullTag{}) {}
  constexpr ~NullHolder() {} // NOLINT(modernize-use-equals-default): the union's member stays alive
};

constinit NullHolder g_null;

} // namespace

thread_local ContextHot *t_current __attribute__((tls_model("initial-exec"))) = &g_null.context;

Context &nullContext() { return g_null.context; }

Context *currentContext() {
  auto *const context = static_cast<Context *>(t_current);
  return context == &g_null.context ? nullptr : context;
}

} // namespace arbiter::state
