#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/jit.h"
#include "state/mirror/mirror.h"

/// Features that the rasterizer draws otherwise than a software host, on purpose. Which of the two
/// draws is never visible, so a draw that has a look keeps its side (kept_look.h).
namespace arbiter::state::software {

/// Rows of looks.def.
enum class Look : std::uint8_t {
#define ARBITER_LOOK(Enumerator, doc) Enumerator,
#include "state/raster_draw/frames/looks.def"
#undef ARBITER_LOOK
};
using Looks = std::uint32_t; ///< one bit a row
[[nodiscard]] constexpr Looks bitOf(Look look) { return 1u << int(look); }

/// The part of a fragment program that decides about looks.
struct LookBasis {
  std::vector<fp::jit::Sampler> samplers; ///< each unit once
  fp::ir::Options options;
  bool isFixed = false;           ///< fixed function's program
  bool readsRasterValues = false; ///< those that go with a raster position, beside its colour
};
[[nodiscard]] LookBasis lookBasisOf(const fp::ir::Program &fragments, bool isFixed);

/// The parts of a draw. The mirror is up to date, with the samplers of the program.
struct LookedAt {
  const Mirror &mirror;
  const LookBasis &fragments;
  bool isBitmap = false;                                   ///< bits give fragments, not vertices
  swrast::Topology topology = swrast::Topology::Triangles; ///< of vertices
};

/// Returns the looks that a draw has, but for those of its buffers. It asks nothing of the
/// host.
[[nodiscard]] Looks looksOf(const LookedAt &draw);
/// Returns the looks that all draws to a colour buffer have.
[[nodiscard]] Looks looksOf(abi::Layout target);

} // namespace arbiter::state::software
