#pragma once
#include <string>

namespace arbiter {

/// Returns the linker's build ID of the library or program that this code is linked into. It
/// changes with every change of the code, and is empty if the linker wrote none.
[[nodiscard]] std::string buildId();

/// Returns the build ID of the library or program that is mapped at an address.
[[nodiscard]] std::string buildIdAt(const void *address);

} // namespace arbiter
