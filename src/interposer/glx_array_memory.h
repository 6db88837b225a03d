#pragma once

namespace arbiter::interposer {

/// Returns a function of NV_vertex_array_range's allocator, which needs no context. The layer
/// always uses its own: a host that has the functions may return no memory (Mesa never does), and a
/// pointer must be freed by the allocator that made it.
/// \return null if the name is not one of the allocator's
[[nodiscard]] void *arrayMemoryFunction(const char *name);

} // namespace arbiter::interposer
