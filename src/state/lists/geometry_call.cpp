#include "state/lists/geometry_call.h"

#include <algorithm>
#include <new>

#include "state/core/control_hooks.h"
#include "state/host_draw/prepare_draw.h"
#include "state/lists/primitive_commands.h"
#include "state/mirror/dirty_bits.h"
#include "state/primitives/geometry.h"
#include "state/primitives/joined.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/draw.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/pipeline.h"
#include "state/raster_draw/raster_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

/// Returns the host's list that draws the same. Requires that no list is being compiled, and no
/// primitive is open.
GLuint hostListOf(RasterContext &context, const Geometry &geometry) {
  return geometry.hostList([&] {
    const GLuint name = context.group->lists.takeSegmentName(*context.host);
    context.host->NewList(name, GL_COMPILE);
    context.host->Begin(geometry.mode);
    geometry.read([&](int slot, const float *value,
                      int components) { setAttribute(*context.host, slot, value, components); },
                  [&] {
                    context.host->End();
                    context.host->Begin(geometry.mode);
                  });
    context.host->End();
    context.host->EndList();
    return name;
  });
}

void callVertices(const RasterContext &context, GLuint list) {
  if (!isObserved(context)) [[likely]]
    return context.host->CallList(list);
  const ListHoldsScope holds(ListHolds::Vertices);
  context.host->CallList(list);
}

/// Has the host draw, after bringing it up to date.
void drawOnHost(RasterContext &context, const Geometry &geometry) {
  if (context.attention && !prepareDraw(context, geometry.mode))
    return setCurrentValues(context, geometry.values, geometry.touched);
  const GLuint list = hostListOf(context, geometry);
  // If the attribute stack is full, the last vertex's values stay.
  const bool restores =
      geometry.fromArrays &&
      context.attribStack.depth() < std::size_t(std::max(context.caps.maxAttribStackDepth, 0));
  if (restores)
    context.host->PushAttrib(GL_CURRENT_BIT);
  callVertices(context, list);
  if (restores)
    context.host->PopAttrib();
  context.dirty |= dirty::kCurrent;
  // Lists of Mesa 22.3.6 leave the values of their last vertex.
  if (geometry.endsOtherwise)
    setCurrentValues(context, geometry.values, geometry.touched);
}

/// Begins an open primitive vertex by vertex, as the application would. Who draws it is decided
/// when it is whole. Requires geometry.open.
void openPrimitive(RasterContext &context, const Geometry &geometry) {
  issueBegin(context, geometry.mode);
  if (ImmediateRecorder *const to = context.recorder) {
    return geometry.read(
        [&](int slot, const float *v, int components) {
          if (slot == kPosition)
            to->vertex(v[0], v[1], v[2], v[3], unsigned(components));
          else
            to->set(slot, v[0], v[1], v[2], v[3], unsigned(components));
        },
        [] {});
  }
  geometry.read([&](int slot, const float *value,
                    int components) { setAttribute(*context.host, slot, value, components); },
                [] {});
  context.dirty |= dirty::kCurrent;
}

/// Returns the vertices of a primitive that begins before all of its attributes are set. Requires
/// that the rasterizer draws it.
VertexSource completed(RasterContext &context, const Geometry &geometry) {
  ContextState &state = *context.software;
  state.mirror.refreshCurrent(context.dirty, geometry.unsetSlots());
  return geometry.source(state.mirror.current, state.listVertices);
}

/// Draws primitives whose vertices depend on each other, joined or one by one. Throws
/// std::bad_alloc if a later one fails than the first.
Outcome drawSeveral(RasterContext &context, const Geometry &geometry, const VertexSource &source) {
  Pipeline &pipeline = pipelineOf(context);
  if (const auto joining = joiningOf(context.software->mirror.raster, geometry.mode, true)) {
    if (geometry.indices.empty())
      return {};
    const IndexRange range = {geometry.indices.data(), std::uint32_t(geometry.indices.size()), 0,
                              geometry.count - 1};
    return pipeline.shadeJoined(context, source, range, *joining);
  }
  for (std::size_t i = 0; i <= geometry.starts.size(); ++i) {
    const std::uint32_t first = i == 0 ? 0 : geometry.starts[i - 1];
    const std::uint32_t end = i == geometry.starts.size() ? geometry.count : geometry.starts[i];
    const Outcome outcome =
        pipeline.shadePart(context, source, {}, first, end - first, pipeline.topology());
    if (!outcome.ok() && i == 0)
      return outcome;
    if (!outcome.ok())
      throw std::bad_alloc();
  }
  return {};
}

/// Draws a primitive and returns true, or brings the host up to date and returns false. Requires
/// usesRasterizer().
bool drawGeometry(RasterContext &context, const Geometry &geometry) {
  return conclude(context, outcomeOf(context, [&] {
                    const Outcome outcome = decide(context, geometry.mode, geometry.count);
                    if (!outcome.ok())
                      return outcome;
                    const VertexSource source =
                        geometry.uniform ? geometry.source() : completed(context, geometry);
                    return geometry.starts.empty() ? drawSource(context, source, geometry.count)
                                                   : drawSeveral(context, geometry, source);
                  }));
}

} // namespace

void callGeometry(RasterContext &context, const Geometry &geometry) {
  if (context.insideBeginEnd) // an error, and the host loses the open primitive's vertices too
    return issueBegin(context, geometry.mode);
  if (geometry.onlyValues)
    return setCurrentValues(context, geometry.values, geometry.touched);
  if (geometry.open)
    return openPrimitive(context, geometry);
  if (mayDraw(context) && usesRasterizer(context) && geometry.count != 0 &&
      drawGeometry(context, geometry))
    return setCurrentValues(context, geometry.values, geometry.touched);
  drawOnHost(context, geometry);
}

} // namespace arbiter::state
