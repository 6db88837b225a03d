#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "control/message.h"
#include "control/server.h"
#include "state/control/session.h"

/// The methods that clients may call (docs/write/control.md).
namespace arbiter::state::remote {

/// One request on the application's thread.
struct Call {
  Session &session;
  Context &context;
  const wire::Request &request;
  wire::ClientId client;
  wire::Params params;
  bool later = false; ///< what is returned is no answer yet: Session::observe() sees to one
};

/// A method that the application's thread answers.
struct Method {
  const char *name;
  wire::Answer (*answer)(Call &call);
  bool writes = false; ///< only the writer may
};

[[nodiscard]] bool isMethod(std::string_view name);
/// Of hello. Any thread.
[[nodiscard]] wire::Json helloAnswer(const std::string &program);
/// Raises no GL error. What finds no memory is a fault. Nothing: it is answered later.
[[nodiscard]] std::optional<wire::Answer> answerRequest(Session &session, Context &context,
                                                        wire::ClientId client,
                                                        const wire::Request &request);
/// A request about the draw that is held.
[[nodiscard]] bool isMethodOfHold(std::string_view name);
/// Its answer. Within the hold, on its thread.
[[nodiscard]] wire::Answer answerOfHold(DrawObserver &observer, const Redraw &redraw,
                                        const wire::Request &request);
/// What the client is told of the draw that is held for it from now on.
[[nodiscard]] wire::Json heldJson(DrawObserver &observer, const ObservedDraw &draw);
/// Of a frame that has ended.
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

/// Puts back what can be put back now of the images that are to be, and forgets them. Images that
/// the application has replaced meanwhile stay.
void putBackStale(Context &context, std::vector<Session::OwnImage> &images);

} // namespace arbiter::state::remote
