// pixel.*: the draws that give a pixel its colour, and values that a draw computes there.
// frame.measure: pixels and time of each draw of a frame.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "control/base64.h"
#include "fp_compiler/ir/print.h"
#include "host/host_table.h"
#include "state/control/methods.h"
#include "state/core/unit_scope.h"
#include "state/raster_draw/raster_context.h"
#include "state/share/share_group.h"
#include "util/json.h"

namespace arbiter::state::control {

namespace {

using wire::Json;

constexpr int kMaxPixels = 64; ///< per side, of one pixel.draw

/// Returns the request's observation. Its pixel must be inside the context's frames.
Observation observationOf(Call &call, Observation::Aim aim) {
  Observation wish;
  wish.aim = aim;
  wish.client = call.client;
  wish.id = call.request.id;
  wish.wantsAnswer = call.request.wantsAnswer;
  int width = 0, height = 0;
  if (!drawableSize(call.context, width, height) || aim == Observation::Aim::Measure)
    return wish;
  wish.framebuffer = GLuint(call.params.integer("framebuffer", 0, UINT32_MAX, 0));
  if (wish.framebuffer != 0) // its size is known when it is drawn to
    width = height = wire::kMaxFrameSide;
  wish.x = int(call.params.integer("x", 0, width - 1));
  wish.y = int(call.params.integer("y", 0, height - 1));
  return wish;
}

wire::Answer observe(Call &call, Observation wish) {
  if (!call.params.ok())
    return call.params.fault();
  int width = 0, height = 0;
  if (!drawableSize(call.context, width, height) || call.context.counters.frames == 0)
    return wire::Fault{wire::kNotPossible, "this context shows no frames", {}};
  if (wish.aim != Observation::Aim::Measure)
    if (const char *const why = whyNoProbe(call.context))
      return wire::Fault{wire::kNotPossible, why, {}};
  if (auto fault = call.session.observe(call.context, std::move(wish)))
    return std::move(*fault);
  call.later = true;
  return Json();
}

Json colorJson(const Vec4 &color) {
  Json values = Json::array();
  for (const float each : color)
    values.push_back(std::isfinite(each) ? Json(each) : Json());
  return values;
}

Json drawJson(const ObservedDraw &draw, Observation::Aim aim) {
  const auto nameOrNull = [](const std::string &name) {
    return name.empty() ? Json() : Json(name);
  };
  Json row = {{"draw", draw.number},
              {"command", draw.command},
              {"fragment", nameOrNull(draw.fragment)},
              {"vertex", nameOrNull(draw.vertex)}};
  if (aim == Observation::Aim::Pick) {
    row["color"] = colorJson(draw.color);
  } else {
    row["pixels"] = draw.pixels ? Json(*draw.pixels) : Json();
    row["milliseconds"] = double(draw.nanoseconds) * 1e-6;
  }
  return row;
}

/// Returns the draws per framebuffer.
Json byFramebuffer(const DrawObserver &observer) {
  Json rows = Json::array();
  for (const auto &[name, draws] : observer.framebuffers())
    rows.push_back({{"framebuffer", name}, {"draws", draws}});
  return rows;
}

/// Returns the sums of each program's draws.
Json byProgram(const DrawObserver &observer) {
  struct Sum {
    std::uint64_t draws = 0, pixels = 0;
    std::int64_t nanoseconds = 0;
    bool counted = true;
  };
  std::map<std::string, Sum> sums;
  for (const ObservedDraw &draw : observer.draws())
    for (const std::string *const id : {&draw.fragment, &draw.vertex}) {
      if (id->empty())
        continue;
      Sum &sum = sums[*id];
      ++sum.draws;
      sum.pixels += draw.pixels.value_or(0);
      sum.counted &= draw.pixels.has_value();
      sum.nanoseconds += draw.nanoseconds;
    }
  Json programs = Json::object();
  for (const auto &[id, sum] : sums)
    programs[id] = {{"draws", sum.draws},
                    {"pixels", sum.counted ? Json(sum.pixels) : Json()},
                    {"milliseconds", double(sum.nanoseconds) * 1e-6}};
  return programs;
}

/// Decodes local parameters: base64 of four floats each. Refuses other lengths and values that are
/// not finite.
std::vector<Vec4> localsOf(wire::Params &params) {
  std::vector<Vec4> locals;
  if (!params.has("locals"))
    return locals;
  const auto bytes = wire::fromBase64(params.text("locals"));
  if (!bytes || bytes->size() % sizeof(Vec4) != 0) {
    params.refuse("locals", "is base64 of four floats each");
    return locals;
  }
  locals.resize(bytes->size() / sizeof(Vec4));
  std::memcpy(static_cast<void *>(locals.data()), bytes->data(), bytes->size());
  for (const Vec4 &value : locals)
    if (!std::all_of(value.begin(), value.end(), [](float each) { return std::isfinite(each); }))
      params.refuse("locals", "are finite numbers");
  return locals;
}

wire::Answer drawHeld(DrawObserver &observer, const Redraw &redraw, wire::Params &params) {
  int width = 0, height = 0;
  (void)observer.targetSize(width, height);
  DrawProbe::Wish wish;
  const std::string text = params.text("text");
  wish.targets = std::size_t(params.integer("targets", 1, DrawProbe::kMaxTargets, 1));
  wish.region.x = int(params.integer("x", 0, std::max(width - 1, 0)));
  wish.region.y = int(params.integer("y", 0, std::max(height - 1, 0)));
  wish.region.width = int(params.integer("width", 1, kMaxPixels, 1));
  wish.region.height = int(params.integer("height", 1, kMaxPixels, 1));
  wish.locals = localsOf(params);
  if (params.has("clear"))
    params.floats("clear", wish.clear.data(), 4);
  if (!params.ok())
    return params.fault();
  wish.depths = observer.depthsOf(wish.region);
  if (!text.empty()) { // else the draw's own program
    auto program = compileProbe(observer.context(), text);
    if (!program)
      return wire::Fault{wire::kNotPossible, program.error(), {}};
    wish.program = std::move(program).value();
  }
  const auto drawn = observer.probe().draw(redraw, wish);
  if (!drawn)
    return wire::Fault{wire::kNotPossible, drawn.error(), {}};
  const auto *const bytes = reinterpret_cast<const std::uint8_t *>(drawn.value().data());
  return Json::object({{"values", wire::toBase64({bytes, drawn.value().size() * sizeof(Vec4)})}});
}

/// Returns the size of the texture on a unit's target.
wire::Answer textureHeld(DrawObserver &observer, wire::Params &params) {
  const auto unit = GLuint(params.integer("unit", 0, 31));
  const std::string word = params.text("target");
  if (!params.ok())
    return params.fault();
  const RasterContext &context = observer.context();
  for (const TextureTarget &target : textureTargets()) {
    if (word != target.word)
      continue;
    const UnitScope scope(*context.host, unit);
    Json size = Json::array();
    for (const GLenum side : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH}) {
      GLint value = 0;
      context.host->GetTexLevelParameteriv(target.image, 0, side, &value);
      size.push_back(value);
    }
    return Json::object({{"size", std::move(size)}});
  }
  params.refuse("target", "is a word of texture.list");
  return params.fault();
}

} // namespace

wire::Answer frameMeasure(Call &call) {
  return observe(call, observationOf(call, Observation::Aim::Measure));
}

wire::Answer pixelPick(Call &call) {
  return observe(call, observationOf(call, Observation::Aim::Pick));
}

wire::Answer pixelHold(Call &call) {
  Observation wish = observationOf(call, Observation::Aim::Hold);
  wish.draw = call.params.integer("draw", 1, INT32_MAX);
  wish.fragment = call.params.text("fragment", "");
  return observe(call, std::move(wish));
}

wire::Answer nothingHeld(Call &) {
  return wire::Fault{wire::kNotPossible,
                     "no draw is held for this client: pixel.hold comes first, and after 2 s "
                     "without a request the application goes on",
                     {}};
}

Json heldJson(DrawObserver &observer, const ObservedDraw &draw) {
  RasterContext &context = observer.context();
  const ProgramTarget &row = context.row(draw.compiled->target);
  const auto bound = context.group->compiledOf(*row.bound);
  const std::string &text = bound ? bound->source() : draw.compiled->source();
  const auto *const renderer = reinterpret_cast<const char *>(context.host->GetString(GL_RENDERER));
  Json answer = drawJson(draw, Observation::Aim::Hold);
  answer.erase("pixels");
  answer.erase("milliseconds");
  int width = 0, height = 0;
  (void)observer.targetSize(width, height);
  answer["framebuffer"] = observer.wish().framebuffer;
  answer["width"] = width;
  answer["height"] = height;
  answer["target"] = row.info().word;
  answer["numerics"] = fp::kNumericsNames[std::size_t(context.numerics)];
  answer["renderer"] = renderer ? renderer : "";
  answer["text"] = text;
  if (!isUtf8(text))
    answer["text_base64"] =
        wire::toBase64({reinterpret_cast<const std::uint8_t *>(text.data()), text.size()});
  return answer;
}

wire::Answer answerOfHold(DrawObserver &observer, const Redraw &redraw,
                          const wire::Request &request) {
  wire::Params params(request.params);
  if (request.method == "pixel.draw")
    return drawHeld(observer, redraw, params);
  if (request.method == "pixel.texture")
    return textureHeld(observer, params);
  return Json::object();
}

wire::Answer observedAnswer(const DrawObserver &observer, std::uint64_t frame) {
  using Aim = Observation::Aim;
  const Observation &wish = observer.wish();
  if (wish.aim == Aim::Hold) {
    std::string why = observer.trouble();
    if (why.empty())
      why = "the frame had " + std::to_string(observer.count()) + " draws";
    return wire::Fault{
        wire::kNotPossible, "draw " + std::to_string(wish.draw) + " cannot be held: " + why, {}};
  }
  Json draws = Json::array();
  for (const ObservedDraw &draw : observer.draws())
    draws.push_back(drawJson(draw, wish.aim));
  Json answer = {{"frame", frame},
                 {"draws", std::move(draws)},
                 {"count", observer.count()},
                 {"lists", observer.lists()},
                 {"framebuffers", byFramebuffer(observer)},
                 {"trouble", observer.trouble().empty() ? Json() : Json(observer.trouble())}};
  if (wish.aim == Aim::Measure)
    answer["programs"] = byProgram(observer);
  return answer;
}

} // namespace arbiter::state::control
