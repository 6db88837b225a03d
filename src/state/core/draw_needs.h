#pragma once
#include <cstdint>

namespace arbiter::state {

/// How long a need lasts (draw_needs.def).
enum class NeedLasts : std::uint8_t { Once, While, Command, Held };

/// Reasons why a draw must do more than call the host: bits of ContextHot::attention. The table
/// says who sets each, what a draw does, and how long it lasts.
namespace attention {
enum class Need : std::uint8_t {
#define NEED(name, lasts) name,
#include "state/core/draw_needs.def"
#undef NEED
};
#define NEED(name, lasts) inline constexpr std::uint32_t k##name = 1u << unsigned(Need::name);
#include "state/core/draw_needs.def"
#undef NEED

inline constexpr std::uint32_t kParameters = kFragmentParameters | kVertexParameters;

/// Bits that stay set when the effective program changes or is validated.
inline constexpr std::uint32_t kRemains = 0
#define NEED(name, lasts) | (NeedLasts::lasts == NeedLasts::Command ? k##name : 0)
#include "state/core/draw_needs.def"
#undef NEED
    ;
} // namespace attention

} // namespace arbiter::state
