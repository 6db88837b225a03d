#include "state/context.h"
#include "state/lifecycle.h"

// Clang 14 takes the strings and vectors of libstdc++ 12 for no literal types. There the null
// context is made by a constructor of this library, which runs before any entry point of it is
// called.
#if defined(__clang__) && __clang_major__ < 15
#define ARBITER_CONSTINIT
#define ARBITER_CONSTEXPR
#else
#define ARBITER_CONSTINIT constinit
#define ARBITER_CONSTEXPR constexpr
#endif

namespace arbiter::state {

namespace {

/// The null context, which is never destroyed: entry points may run in other libraries'
/// destructors.
struct NullHolder {
  union {
    Context context;
  };
  ARBITER_CONSTEXPR NullHolder() : context(Context::NullTag{}) {}
  ARBITER_CONSTEXPR ~NullHolder() {
  } // NOLINT(modernize-use-equals-default): the union's member stays alive
};

ARBITER_CONSTINIT NullHolder g_null;

} // namespace

thread_local ContextHot *t_current __attribute__((tls_model("initial-exec"))) = &g_null.context;

Context &nullContext() { return g_null.context; }

Context *currentContext() {
  auto *const context = static_cast<Context *>(t_current);
  return context == &g_null.context ? nullptr : context;
}

} // namespace arbiter::state
