#pragma once
#include <optional>
#include <string>

#include "util/cache/keyed_hash.h"

namespace arbiter {

/// The secret of a cache's folder, 16 random bytes in its file "key": what is stored is signed with
/// it, so that a file which another user, another machine or another folder made is no entry. Made
/// at the first call; one that is not the user's own, that others may read, or that is not whole is
/// replaced, and with it all that was signed. Nothing if there is none and none can be made.
/// \param folder exists, is the user's, and no other user may write to it
[[nodiscard]] std::optional<HashKey> cacheKeyOf(const std::string &folder);

} // namespace arbiter
