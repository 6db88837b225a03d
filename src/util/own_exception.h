#pragma once
#include <exception>

namespace arbiter {

/// Rethrows `error` if it did not come from this library; called in a handler for std::exception
/// around calls of the host. An exception from a callback or an X error handler belongs to the
/// application, as without the layer. The C++ library is linked statically into the layer, so its
/// exceptions have type information of their own. If it is linked dynamically, an application's
/// standard exception is taken for the layer's.
void passOn(const std::exception &error);

} // namespace arbiter
