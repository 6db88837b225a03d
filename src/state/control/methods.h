#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "control/message.h"
#include "control/server.h"
#include "state/control/session.h"

/// What clients may ask for (docs/control.md).
namespace arbiter::state::remote {

/// One request on the application's thread.
struct Call {
  Session &session;
  Context &context;
  wire::ClientId client;
  wire::Params params;
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
/// Raises no GL error. What finds no memory is a fault.
[[nodiscard]] wire::Answer answerRequest(Session &session, Context &context, wire::ClientId client,
                                         const wire::Request &request);

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
[[nodiscard]] wire::Answer stats(Call &call);

/// Puts back what can be put back now of the images that are to be, and forgets them. Images that
/// the application has replaced meanwhile stay.
void putBackStale(Context &context, std::vector<Session::OwnImage> &images);

} // namespace arbiter::state::remote
