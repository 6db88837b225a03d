#pragma once
#include <exception>

namespace arbiter {

/// Inside a handler for std::exception around calls of the host: throws `error` on if it is not of
/// this library. What an application throws out of a callback that the host calls, or its X error
/// handler, is the application's to catch, as it is without the layer. The C++ library is linked
/// into the layer, so its own exceptions have type information of its own; where it is not, an
/// exception of the C++ library's may be the application's, and is taken for the layer's.
void passOn(const std::exception &error);

} // namespace arbiter
