#pragma once
#include "nv_texts.h"
#include "rows.h"

namespace bench {

/// Returns four rows for each pair: `nv-frame/NAME, ARB` and `..., NV` draw a frame of the whole
/// surface (for vertex programs a grid of vertices that are all culled), and `nv-load/...` load the
/// texts. Returns none if the context lacks NVIDIA's extensions.
[[nodiscard]] const std::vector<Row> &nvRows();

/// Returns the fraction of the surface's pixels that differ by more than 2 of 255 between the
/// pictures of a pair's two texts; negative if there is no such pair.
[[nodiscard]] double nvDifference(std::string_view name);

} // namespace bench
