#include "apps/tools/debug/start.h"

#include "apps/tools/launch/in_layer.h"

namespace arbiter::tools::debug {

namespace {

constexpr const char *kNames[] = {"swrast", "host", "bare host"};

/// Returns the layer's settings for drawing. No profile may reject programs that show values, which
/// can exceed a card's limits and write several colors. The document itself was checked before.
LayerArguments layerOf(const DrawWith &with) {
  LayerArguments layer;
  layer.library = with.library;
  layer.profile = "host";
  layer.limits = "report";
  layer.identity = "host";
  layer.numerics = with.numerics;
  layer.stats = with.statistics;
  layer.backend = with.backend == Backend::Swrast ? "swrast" : "host";
  return layer;
}

} // namespace

Result<std::unique_ptr<DrawClient>, DebugError> startDrawing(const DrawWith &with,
                                                             const control::Json &what) {
  std::vector<Assignment> environment;
  if (with.backend != Backend::Bare) {
    const auto launch = layerLaunch(layerOf(with));
    if (!launch)
      return DebugError{launch.error().message, true};
    environment = launch.value().environment;
  }
  auto client = DrawClient::start(kNames[std::size_t(with.backend)], [&] {
    return execute(environment, {"/proc/self/exe", kDrawsVerb});
  });
  if (client)
    if (auto error = client.value()->open(what))
      return *error;
  return client;
}

} // namespace arbiter::tools::debug
