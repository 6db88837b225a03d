#pragma once

namespace arbiter::interposer {

/// The allocator of NV_vertex_array_range, which needs no context: always the layer's, as hosts
/// that have the functions may give nothing (Mesa's never do), and a pointer is freed where it came
/// from.
/// \return the function of that name; null: the name is none of the allocator's
[[nodiscard]] void *arrayMemoryFunction(const char *name);

} // namespace arbiter::interposer
