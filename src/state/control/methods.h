#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "control/message.h"
#include "control/server.h"
#include "state/control/session.h"

/// The methods that clients may call (docs/write/control.md).
namespace arbiter::state::control {

/// A request that the application's thread executes.
struct Call {
  Session &session;
  RasterContext &context;
  const wire::Request &request;
  wire::ClientId client;
  wire::Params params;
  bool later = false; ///< the result is no answer: Session::observe() sends one later
};

/// A method that the application's thread answers.
struct Method {
  const char *name;
  wire::Answer (*answer)(Call &call);
  bool writes = false; ///< only the writer may call it
};

[[nodiscard]] bool isMethod(std::string_view name);
/// Returns the answer to hello. Any thread may call it.
[[nodiscard]] wire::Json helloAnswer(const std::string &program);
/// Executes a request. Raises no GL error, and returns a fault without memory. Returns nothing if
/// the request is answered later.
[[nodiscard]] std::optional<wire::Answer> answerRequest(Session &session, RasterContext &context,
                                                        wire::ClientId client,
                                                        const wire::Request &request);
/// True for methods about the held draw.
[[nodiscard]] bool isMethodOfHold(std::string_view name);
/// Executes such a request, on the thread of the hold.
[[nodiscard]] wire::Answer answerOfHold(DrawObserver &observer, const Redraw &redraw,
                                        const wire::Request &request);
/// Returns what the client is told when a draw is held for it.
[[nodiscard]] wire::Json heldJson(DrawObserver &observer, const ObservedDraw &draw);
/// Returns the answer for an observed frame that has ended.
[[nodiscard]] wire::Answer observedAnswer(const DrawObserver &observer, std::uint64_t frame);

// The methods, by file.
[[nodiscard]] wire::Answer programList(Call &call);
[[nodiscard]] wire::Answer programGet(Call &call);
[[nodiscard]] wire::Answer programSet(Call &call);
[[nodiscard]] wire::Answer programReset(Call &call);
[[nodiscard]] wire::Answer programEnable(Call &call);
[[nodiscard]] wire::Answer paramList(Call &call);
[[nodiscard]] wire::Answer paramSet(Call &call);
[[nodiscard]] wire::Answer paramReset(Call &call);
[[nodiscard]] wire::Answer textureList(Call &call);
[[nodiscard]] wire::Answer textureGet(Call &call);
[[nodiscard]] wire::Answer textureSet(Call &call);
[[nodiscard]] wire::Answer textureReset(Call &call);
[[nodiscard]] wire::Answer frameWant(Call &call);
[[nodiscard]] wire::Answer frameMeasure(Call &call);
[[nodiscard]] wire::Answer pixelPick(Call &call);
[[nodiscard]] wire::Answer pixelHold(Call &call);
[[nodiscard]] wire::Answer nothingHeld(Call &call);
[[nodiscard]] wire::Answer stats(Call &call);

/// Restores stale images where that is possible now, and forgets them. Images that the application
/// has replaced meanwhile stay.
void putBackStale(RasterContext &context, std::vector<Session::OwnImage> &images);

} // namespace arbiter::state::control
