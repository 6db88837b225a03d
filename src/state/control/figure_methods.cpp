// stats: figures of the process.
#include <array>

#include "state/control/known_programs.h"
#include "state/control/methods.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

wire::Answer stats(Call &call) {
  using wire::Json;
  const RasterContext &context = call.context;
  Json draws = Json::object();
  for (int i = 0; i < kPathCount; ++i)
    if (const std::uint64_t count = context.counters.draws[std::size_t(i)]; count != 0)
      draws[pathName(Path(i))] = count;
  Json given = Json::object();
  if (context.software)
    for (int i = 0; i < kFallbackCount; ++i)
      if (context.software->fallbacks[std::size_t(i)] != 0)
        given[fallbackName(Fallback(i))] = context.software->fallbacks[std::size_t(i)];
  std::size_t programs = 0, over = 0;
  for (const auto &[id, program] : knownPrograms(call.session, call.context)) {
    ++programs;
    over += program.compiled->underNativeLimits ? 0u : 1u;
  }
  const FrameTimes &times = call.session.frameTimes();
  return Json::object({{"frames", call.session.frames()},
                       {"frame_milliseconds",
                        {{"last", times.last()}, {"mean", times.mean()}, {"worst", times.worst()}}},
                       {"context", context.serial},
                       {"draws", std::move(draws)},
                       {"programs", programs},
                       {"over_native", over},
                       {"software",
                        {{"drawn", context.software ? context.software->drawn : 0},
                         {"given_to_host", std::move(given)}}}});
}

} // namespace arbiter::state::control
