#pragma once
#include <string>

namespace arbiter {

/// What the linker wrote about the content of the library or program that this is linked into: it
/// changes with any change of its code. Empty if it was linked without.
[[nodiscard]] std::string buildId();

/// The same of the library or program that is mapped at an address.
[[nodiscard]] std::string buildIdAt(const void *address);

} // namespace arbiter
