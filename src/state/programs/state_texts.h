#pragma once
#include <memory>

#include "state/programs/state_text.h"

namespace arbiter::state {

/// Returns a context's texts of states, or null if nothing captures or replaces them.
[[nodiscard]] std::unique_ptr<StateTexts> makeStateTexts();

} // namespace arbiter::state
