#pragma once

namespace arbiter::state {

/// What is known in a context of its planes' enables, without a question to the host.
struct ClipPlanes {
  bool used = false; ///< one was enabled at some time: until then none can be
  bool known = true; ///< `enabled` is the host's answer since the last change
  bool enabled = false;
};

} // namespace arbiter::state
