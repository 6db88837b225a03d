#include "apps/tools/debug/start.h"

#include "apps/tools/launch/launch.h"

namespace arbiter::tools::debug {

namespace {

constexpr const char *kNames[] = {"swrast", "host", "bare host"};

/// Returns the layer's settings for drawing. No profile may reject programs that show values, which
/// can exceed a card's limits and write several colors. The document itself was checked before.
LayerArguments layerOf(const DrawWith &with) {
  LayerArguments layer;
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
    const auto files = findLayer(with.library);
    if (!files)
      return DebugError{files.error().message, true};
    auto found = layerEnvironment(files.value(), layerOf(with));
    if (!found)
      return DebugError{found.error().message, true};
    environment = std::move(found).value();
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
