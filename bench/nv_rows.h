#pragma once
#include "nv_texts.h"
#include "rows.h"

namespace bench {

/// Of each pair four rows: `nv-frame/NAME, ARB` and `..., NV`, a frame of the whole surface (of a
/// grid of vertices that are all culled, for vertex programs), and `nv-load/...`. None where the
/// context lacks NVIDIA's extensions.
[[nodiscard]] const std::vector<Row> &nvRows();

/// The part of the surface's pixels that are further apart than 2 of 255 between the pictures of a
/// pair's two texts; negative if there is no such pair.
[[nodiscard]] double nvDifference(std::string_view name);

} // namespace bench
