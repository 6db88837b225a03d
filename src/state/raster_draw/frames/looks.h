#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/jit.h"
#include "state/mirror/mirror.h"

/// Looks: features that the rasterizer deliberately draws differently from a software host. Nobody
/// should see which of the two draws, so one side draws all looks of a context (kept_look.h).
namespace arbiter::state {

/// The rows of looks.def.
enum class Look : std::uint8_t {
#define ARBITER_LOOK(Enumerator, doc) Enumerator,
#include "state/raster_draw/frames/looks.def"
#undef ARBITER_LOOK
};
using Looks = std::uint32_t; ///< one bit for each row
[[nodiscard]] constexpr Looks bitOf(Look look) { return 1u << int(look); }

/// The parts of a fragment program that decide about looks.
struct LookBasis {
  std::vector<fp::jit::Sampler> samplers; ///< one for each unit
  fp::ir::Options options;
  bool isFixed = false; ///< true for fixed function's program
  /// true if it reads values of the raster position other than the colour
  bool readsRasterValues = false;
};
[[nodiscard]] LookBasis lookBasisOf(const fp::ir::Program &fragments, bool isFixed);

/// The parts of a draw that decide about looks. The mirror must be up to date, including the
/// program's samplers.
struct LookedAt {
  const Mirror &mirror;
  const LookBasis &fragments;
  bool isBitmap = false; ///< true if bits make the fragments, not vertices
  swrast::Topology topology = swrast::Topology::Triangles; ///< topology of the vertices
};

/// Returns the looks of a draw, except those of its colour buffers. Does not query the host.
[[nodiscard]] Looks looksOf(const LookedAt &draw);
/// Returns the looks of all draws to a colour buffer with this layout.
[[nodiscard]] Looks looksOf(abi::Layout target);

} // namespace arbiter::state
