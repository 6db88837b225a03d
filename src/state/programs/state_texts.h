#pragma once
#include <memory>

#include "state/programs/state_text.h"

namespace arbiter::state {

/// The texts of a context's states; null where nothing captures or replaces them.
[[nodiscard]] std::unique_ptr<StateTexts> makeStateTexts();

} // namespace arbiter::state
