// Finds state that keeps every draw with the host, and queries the polygon stipple.
#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

/// True if a query is active that counts samples or primitives.
bool queryActive(const HostCaps &caps, const HostQuery &query) {
  const auto active = [&](bool offered, GLenum target) {
    GLint name = 0;
    if (offered)
      query.host.GetQueryiv(target, GL_CURRENT_QUERY, &name);
    return name != 0;
  };
  return active(caps.occlusionQuery, GL_SAMPLES_PASSED) ||
         active(caps.anySamples, GL_ANY_SAMPLES_PASSED) ||
         active(caps.anySamplesConservative, GL_ANY_SAMPLES_PASSED_CONSERVATIVE) ||
         active(caps.transformFeedback, GL_PRIMITIVES_GENERATED);
}

struct Cap {
  bool HostCaps::*offered;
  GLenum cap;
  const char *name;
};
constexpr Cap kCaps[] = {
    {&HostCaps::transformFeedback, GL_RASTERIZER_DISCARD, "RASTERIZER_DISCARD"},
    {&HostCaps::depthBounds, GL_DEPTH_BOUNDS_TEST_EXT, "DEPTH_BOUNDS_TEST"},
    {&HostCaps::srgbFramebuffer, GL_FRAMEBUFFER_SRGB, "FRAMEBUFFER_SRGB"},
};

/// Shading extensions that a GPU's driver may have. Where the layer offers one, the host's enable
/// is never set, so a set enable means that the host must shade.
struct DriversCap {
  const char *extension;
  GLenum cap;
  const char *name;
};
constexpr DriversCap kDriversCaps[] = {
    {"GL_NV_register_combiners", GL_REGISTER_COMBINERS_NV, "the host's REGISTER_COMBINERS_NV"},
    {"GL_NV_texture_shader", GL_TEXTURE_SHADER_NV, "the host's TEXTURE_SHADER_NV"},
    {"GL_NV_fragment_program", GL_FRAGMENT_PROGRAM_NV, "the host's FRAGMENT_PROGRAM_NV"},
};

/// True if points use the host's NV_point_sprite, which derives the third coordinate from the
/// others.
bool spritesHaveThird(const HostCaps &caps, const HostQuery &query) {
  return caps.has("GL_NV_point_sprite") && query.enabled(GL_POINT_SPRITE) &&
         query.name(GL_POINT_SPRITE_R_MODE_NV) != GL_ZERO;
}

bool clipControlled(const HostCaps &caps, const HostQuery &query) {
  return caps.clipControl && (query.name(GL_CLIP_ORIGIN) != GL_LOWER_LEFT ||
                              query.name(GL_CLIP_DEPTH_MODE) != GL_NEGATIVE_ONE_TO_ONE);
}

} // namespace

void queryObstacles(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  mirror.obstacle = mirror.obstacleDetail = nullptr;
  const auto note = [&](const char *reason, const char *what) {
    refuse(mirror.obstacle, mirror.obstacleDetail, reason, what);
  };
  if (query.name(GL_RENDER_MODE) != GL_RENDER)
    note("query", "RENDER_MODE");
  if (mirror.conditional)
    note("query", "conditional rendering");
  if (queryActive(caps, query))
    note("query", "an active query");
  if (caps.transformFeedback2 && query.boolean(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE))
    note("query", "transform feedback");
  for (const Cap &cap : kCaps)
    if (caps.*cap.offered && query.enabled(cap.cap))
      note("state", cap.name);
  if (!caps.onProcessor) { // no software host has them
    for (const DriversCap &cap : kDriversCaps)
      if (caps.has(cap.extension) && query.enabled(cap.cap))
        note("state", cap.name);
    if (spritesHaveThird(caps, query))
      note("state", "the host's POINT_SPRITE_R_MODE_NV");
  }
  if (clipControlled(caps, query))
    note("state", "CLIP_ORIGIN or CLIP_DEPTH_MODE");
  if (mirror.blendLacking)
    note("state", "a blend function of two sources, or an advanced equation");
}

void queryPolygonStipple(const HostCaps &caps, const HostQuery &query, std::uint8_t rows[128]) {
  // The host packs the pattern like an image, so the pack state must be plain for the query.
  struct Store {
    GLenum pname;
    GLint plain;
    GLint before = 0;
  };
  Store stores[] = {{GL_PACK_SWAP_BYTES, 0}, {GL_PACK_LSB_FIRST, 0},   {GL_PACK_ROW_LENGTH, 0},
                    {GL_PACK_SKIP_ROWS, 0},  {GL_PACK_SKIP_PIXELS, 0}, {GL_PACK_ALIGNMENT, 1}};
  for (Store &store : stores) {
    store.before = query.integer(store.pname);
    if (store.before != store.plain)
      query.host.PixelStorei(store.pname, store.plain);
  }
  const GLint buffer = caps.pixelBuffers ? query.integer(GL_PIXEL_PACK_BUFFER_BINDING) : 0;
  if (buffer != 0)
    query.host.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  query.host.GetPolygonStipple(rows);
  if (buffer != 0)
    query.host.BindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(buffer));
  for (const Store &store : stores)
    if (store.before != store.plain)
      query.host.PixelStorei(store.pname, store.before);
}

} // namespace arbiter::state
