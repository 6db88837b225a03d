#include "state/mirror/mirror.h"

#include <algorithm>
#include <cstring>

#include "state/mirror/host_query.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

using CurrentMatrix = GenerationCounter::CurrentMatrix;

void queryViewport(const HostQuery &query, Mirror &mirror) {
  swrast::RasterState &raster = mirror.raster;
  GLfloat range[2] = {0, 1};
  GLint box[4] = {};
  query.host.GetFloatv(GL_VIEWPORT, raster.viewport);
  query.host.GetFloatv(GL_DEPTH_RANGE, range);
  raster.depthNear = range[0];
  raster.depthFar = range[1];
  mirror.scissorEnabled = query.enabled(GL_SCISSOR_TEST);
  mirror.scissor = {0, 0, INT16_MAX, INT16_MAX};
  if (!mirror.scissorEnabled)
    return;
  query.host.GetIntegerv(GL_SCISSOR_BOX, box);
  mirror.scissor = {box[0], box[1], box[2], box[3]};
}

swrast::PolygonMode polygonMode(GLint mode) {
  switch (mode) {
  case GL_POINT:
    return swrast::PolygonMode::Point;
  case GL_LINE:
    return swrast::PolygonMode::Line;
  default:
    return swrast::PolygonMode::Fill;
  }
}

void queryPolygons(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  swrast::RasterState &raster = mirror.raster;
  raster.cullFront = raster.cullBack = false;
  if (query.enabled(GL_CULL_FACE)) {
    const GLenum face = query.name(GL_CULL_FACE_MODE);
    raster.cullFront = face != GL_BACK;
    raster.cullBack = face != GL_FRONT;
  }
  raster.frontIsClockwise = query.name(GL_FRONT_FACE) == GL_CW;
  raster.flatShade = query.name(GL_SHADE_MODEL) == GL_FLAT;
  raster.provokingIsFirst =
      caps.provokingVertex && query.name(GL_PROVOKING_VERTEX) == GL_FIRST_VERTEX_CONVENTION;
  raster.quadsProvokingIsFirst = raster.provokingIsFirst && caps.quadsFollowProvokingVertex;
  raster.depthClamp = caps.depthClamp && query.enabled(GL_DEPTH_CLAMP);
  GLint modes[2] = {GL_FILL, GL_FILL};
  query.host.GetIntegerv(GL_POLYGON_MODE, modes);
  raster.front = polygonMode(modes[0]);
  raster.back = polygonMode(modes[1]);
  raster.offsetFill = query.enabled(GL_POLYGON_OFFSET_FILL);
  raster.offsetLine = query.enabled(GL_POLYGON_OFFSET_LINE);
  raster.offsetPoint = query.enabled(GL_POLYGON_OFFSET_POINT);
  raster.offsetFactor = query.number(GL_POLYGON_OFFSET_FACTOR);
  raster.offsetUnits = query.number(GL_POLYGON_OFFSET_UNITS);
  raster.polygonStipple = nullptr;
  if (query.enabled(GL_POLYGON_STIPPLE)) {
    queryPolygonStipple(caps, query, mirror.polygonStipple);
    raster.polygonStipple = mirror.polygonStipple;
  }
}

void queryLinesAndPoints(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  swrast::RasterState &raster = mirror.raster;
  raster.lineEndsAsEdges = caps.lineEndsAsEdges;
  raster.lineWidth = query.number(GL_LINE_WIDTH);
  mirror.smoothLines = query.enabled(GL_LINE_SMOOTH);
  raster.lineStippleFactor = 0;
  if (query.enabled(GL_LINE_STIPPLE)) {
    raster.lineStippleFactor = query.integer(GL_LINE_STIPPLE_REPEAT);
    raster.lineStipple = std::uint16_t(query.integer(GL_LINE_STIPPLE_PATTERN));
  }
  raster.pointSize = query.number(GL_POINT_SIZE);
  raster.pointSizeMinimum = query.number(GL_POINT_SIZE_MIN);
  raster.pointSizeMaximum = query.number(GL_POINT_SIZE_MAX);
  mirror.smoothPoints = query.enabled(GL_POINT_SMOOTH);
  mirror.pointSizeFromProgram = query.enabled(GL_VERTEX_PROGRAM_POINT_SIZE);
  mirror.twoSidedColor = query.enabled(GL_VERTEX_PROGRAM_TWO_SIDE);
}

/// Sets the range that fragment depths are clamped to. With ARB_depth_clamp it is the depth range.
/// Else it is the range of the buffer, also for a program's depth outside the depth range
/// (ARB_fragment_program, 3.11.4.4).
void limitDepths(Mirror &mirror) {
  const swrast::RasterState &raster = mirror.raster;
  const auto [least, most] = std::minmax(raster.depthNear, raster.depthFar);
  mirror.constants.depthMinimum = raster.depthClamp ? float(least) : 0.0f;
  mirror.constants.depthMaximum = raster.depthClamp ? float(most) : 1.0f;
}

/// Queries point sprites. COORD_REPLACE is per unit, so the active unit has to move.
void queryPointSprites(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  mirror.spriteCoords = 0;
  mirror.sprites = query.enabled(GL_POINT_SPRITE);
  if (!mirror.sprites)
    return;
  mirror.raster.spriteOriginLowerLeft = query.name(GL_POINT_SPRITE_COORD_ORIGIN) == GL_LOWER_LEFT;
  const UnitsScope units(query.host);
  for (int unit = 0; unit < std::min(caps.maxTextureCoords, 8); ++unit) {
    GLint replace = 0;
    units.select(unit);
    query.host.GetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replace);
    mirror.spriteCoords |= std::uint8_t((replace != 0) << unit);
  }
}

} // namespace

void Mirror::refresh(std::uint32_t &dirty) {
  clock.take(dirty);
  const HostQuery query{m_host};
  if (clock.currentMatrix() == CurrentMatrix::Unknown) [[unlikely]]
    clock.setCurrentMatrix(query.name(GL_MATRIX_MODE) == GL_MODELVIEW ? CurrentMatrix::Modelview
                                                                      : CurrentMatrix::Other);
  const std::uint32_t groups = clock.changedSince(seen);
  if (groups == 0) [[likely]]
    return;
  seen = clock.now();
  if ((groups & dirty::kViewport) != 0)
    queryViewport(query, *this);
  if ((groups & dirty::kRaster) != 0) {
    queryPolygons(m_caps, query, *this);
    queryLinesAndPoints(m_caps, query, *this);
  }
  if ((groups & (dirty::kViewport | dirty::kRaster)) != 0)
    limitDepths(*this);
  if ((groups & (dirty::kTexGen | dirty::kTextureParameters | dirty::kRaster)) != 0)
    queryPointSprites(m_caps, query, *this);
  if ((groups & dirty::kPixelOps) != 0)
    queryPixelOps(m_caps, query, *this);
  if ((groups & (dirty::kQueries | dirty::kPixelOps | dirty::kRaster | dirty::kViewport)) != 0)
    queryObstacles(m_caps, query, *this);
}

bool Mirror::drawnAs(swrast::Topology topology, swrast::PolygonMode mode) const {
  return topology >= swrast::Topology::Triangles &&
         ((raster.front == mode && !raster.cullFront) || (raster.back == mode && !raster.cullBack));
}

bool Mirror::drawsPoints(swrast::Topology topology) const {
  return topology == swrast::Topology::Points || drawnAs(topology, swrast::PolygonMode::Point);
}

bool Mirror::drawsLines(swrast::Topology topology) const {
  using swrast::Topology;
  return (topology < Topology::Triangles && topology != Topology::Points) ||
         drawnAs(topology, swrast::PolygonMode::Line);
}

abi::Coverage Mirror::coverageOf(swrast::Topology topology) const {
  if (smoothLines && drawsLines(topology))
    return abi::Coverage::Line;
  return smoothPoints && drawsPoints(topology) ? abi::Coverage::Disc : abi::Coverage::Whole;
}

const char *Mirror::obstacleOf(swrast::Topology topology) const {
  const bool filled = drawnAs(topology, swrast::PolygonMode::Fill);
  const int kinds = int(filled) + int(drawsLines(topology)) + int(drawsPoints(topology));
  const bool isSmooth = coverageOf(topology) != abi::Coverage::Whole;
  // Smooth polygons are drawn like others, as software hosts do.
  const bool lacks = (isSmooth && kinds > 1) || // one function handles one kind of coverage
                     (smoothPoints && sprites);
  return lacks ? "state" : nullptr;
}

} // namespace arbiter::state
