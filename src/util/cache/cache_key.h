#pragma once
#include <optional>
#include <string>

#include "util/cache/keyed_hash.h"

namespace arbiter {

/// Returns the secret of a cache's folder: 16 random bytes in its file "key". Entries are signed
/// with it, so that files made by another user, machine or folder are not accepted. The first call
/// creates the file. A key that is incomplete, readable by others or owned by another user is
/// replaced, which invalidates all signed entries. Returns nothing if there is no key and none can
/// be made.
/// \param folder exists, belongs to the user, and no other user may write to it
[[nodiscard]] std::optional<HashKey> cacheKeyOf(const std::string &folder);

} // namespace arbiter
