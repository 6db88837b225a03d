#include "state/software/context_state.h"

#include "state/context.h"

namespace arbiter::state::software {

const char *fallbackName(Fallback reason) {
  switch (reason) {
#define ARBITER_FALLBACK(Enumerator, key, doc)                                                     \
  case Fallback::Enumerator:                                                                       \
    return key;
#include "state/software/reasons.def"
#undef ARBITER_FALLBACK
  }
  return "";
}

ContextState::ContextState() = default;
ContextState::~ContextState() = default;

} // namespace arbiter::state::software
