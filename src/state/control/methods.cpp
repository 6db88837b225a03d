#include "state/control/methods.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <exception>
#include <unistd.h>

#include "state/core/host_errors.h"
#include "state/raster_draw/raster_context.h"
#include "util/own_exception.h"

namespace arbiter::state::control {

namespace {

constexpr Method kMethods[] = {
    {"program.list", programList},
    {"program.get", programGet},
    {"program.set", programSet, true},
    {"program.reset", programReset, true},
    {"program.enable", programEnable, true},
    {"param.list", paramList},
    {"param.set", paramSet, true},
    {"param.reset", paramReset, true},
    {"texture.list", textureList},
    {"texture.get", textureGet},
    {"texture.set", textureSet, true},
    {"texture.reset", textureReset, true},
    {"frame.want", frameWant},
    {"frame.measure", frameMeasure},
    {"pixel.pick", pixelPick},
    {"pixel.hold", pixelHold},
    {"pixel.draw", nothingHeld},
    {"pixel.texture", nothingHeld},
    {"pixel.release", nothingHeld},
    {"stats", stats},
};

const Method *findMethod(std::string_view name) {
  const auto *const found = std::find_if(std::begin(kMethods), std::end(kMethods),
                                         [&](const Method &row) { return name == row.name; });
  return found == std::end(kMethods) ? nullptr : found;
}

} // namespace

bool isMethod(std::string_view name) { return findMethod(name) != nullptr; }

wire::Json helloAnswer(const std::string &program) {
  wire::Json methods = wire::Json::array({"hello", "ping", "frame.release"});
  for (const Method &row : kMethods)
    methods.push_back(row.name);
  return wire::Json::object({{"protocol", wire::kProtocol},
                             {"server", "layer"},
                             {"version", ARBITER_VERSION_TEXT},
                             {"pid", getpid()},
                             {"program", program},
                             {"methods", std::move(methods)}});
}

bool isMethodOfHold(std::string_view name) {
  const Method *const method = findMethod(name);
  return method && method->answer == nothingHeld;
}

std::optional<wire::Answer> answerRequest(Session &session, RasterContext &context,
                                          wire::ClientId client, const wire::Request &request) {
  const Method *const method = findMethod(request.method);
  if (!method)
    return wire::Fault{wire::kNoMethod, "there is no such method", {}};
  try {
    if (context.passThrough)
      return wire::Fault{wire::kNotPossible,
                         "OpenGL ES and core profiles are passed through: nothing is known of them",
                         {}};
    if (method->writes)
      if (std::optional<wire::Fault> fault = session.becomeWriter(client))
        return std::move(*fault);
    const HostErrorScope errors(*context.host, context.errors.pending);
    Call call = {session, context, request, client, wire::Params(request.params)};
    wire::Answer answer = method->answer(call);
    if (call.later)
      return std::nullopt;
    return answer;
  } catch (const std::exception &error) {
    passOn(error);
    return wire::Fault{wire::kTooBusy, "the process has no memory for it", {}};
  }
}

wire::Answer frameWant(Call &call) {
  const auto every = std::uint32_t(call.params.integer("every", 0, 1'000'000, 1));
  const int width = int(call.params.integer("width", 0, wire::kMaxFrameSide, 0));
  const int height = int(call.params.integer("height", 0, wire::kMaxFrameSide, 0));
  if (!call.params.ok())
    return call.params.fault();
  int w = 0, h = 0;
  if (every != 0 && (!drawableSize(call.context, w, h) || call.context.counters.frames == 0))
    return wire::Fault{wire::kNotPossible, "this context shows no frames", {}};
  call.session.wantFrames(call.client, every, width, height);
  return wire::Json::object();
}

} // namespace arbiter::state::control
