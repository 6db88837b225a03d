// texture.*: textures that are bound at the end of the frame.
#include <algorithm>
#include <optional>

#include "control/base64.h"
#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/control/methods.h"
#include "state/core/texture_binding.h"
#include "state/core/unit_scope.h"
#include "state/raster_draw/raster_context.h"
#include "state/report/format_name.h"
#include "state/share/share_group.h"

namespace arbiter::state::control {

namespace {

using wire::Json;

/// True if the image belongs to the context. A share group has common names, but each context has
/// its own textures 0.
bool isOf(const Session::OwnImage &image, const RasterContext &context) {
  return image.group.lock() == context.group &&
         (image.texture.name != 0 || image.context == context.serial);
}

Session::OwnImage *ownImageOf(Session &session, const RasterContext &context,
                              const BoundTexture &texture) {
  auto &images = session.ownImages();
  const auto found = std::find_if(images.begin(), images.end(), [&](const auto &image) {
    return image.texture.name == texture.name && image.texture.target == texture.target &&
           isOf(image, context);
  });
  return found == images.end() ? nullptr : &*found;
}

/// Returns the bound texture with `name` and, if given, `target`.
std::optional<BoundTexture> findTexture(Call &call) {
  const auto name = GLint(call.params.integer("name", 0, INT32_MAX));
  const std::string target = call.params.text("target", "");
  if (!call.params.ok())
    return std::nullopt;
  for (const BoundTexture &texture : boundTextures(call.context))
    if (texture.name == name && (target.empty() || target == textureTargets()[texture.target].word))
      return texture;
  return std::nullopt;
}

wire::Fault notFound(const Call &call) {
  if (!call.params.ok())
    return call.params.fault();
  return {wire::kUnknownName, "no such texture is bound where the frame ends", {}};
}

Json imageJson(const Picture &picture) {
  return Json::object({{"width", picture.width},
                       {"height", picture.height},
                       {"rgba", wire::toBase64(picture.bytes)}});
}

std::optional<Picture> imageOf(Call &call) {
  static const Json s_none = Json::object();
  const Json *const object = call.params.object("image");
  wire::Params image(object ? *object : s_none);
  Picture picture;
  picture.width = int(image.integer("width", 1, wire::kMaxFrameSide));
  picture.height = int(image.integer("height", 1, wire::kMaxFrameSide));
  auto bytes = wire::fromBase64(image.text("rgba"));
  if (!image.ok() || !bytes ||
      bytes->size() != std::size_t(picture.width) * std::size_t(picture.height) * 4) {
    call.params.refuse("image", "has width, height and rgba, base64 of four bytes a pixel");
    return std::nullopt;
  }
  picture.bytes = std::move(*bytes);
  return picture;
}

/// True if 8 bits per component hold all of the texture.
bool holdsBytes(RasterContext &context, const BoundTexture &texture) {
  const UnitScope unit(*context.host, texture.unit);
  const GLenum image = textureTargets()[texture.target].image;
  for (const GLenum size :
       {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
        GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE}) {
    GLint bits = 0;
    context.host->GetTexLevelParameteriv(image, 0, size, &bits);
    if (bits > 8)
      return false;
  }
  GLint compressed = 0;
  context.host->GetTexLevelParameteriv(image, 0, GL_TEXTURE_COMPRESSED, &compressed);
  return compressed == 0;
}

/// Binds the texture if no unit has it, and restores the binding.
class Rebound {
public:
  Rebound(RasterContext &context, BoundTexture &texture) {
    const auto bound = boundTextures(context);
    const auto found = std::find_if(bound.begin(), bound.end(), [&](const BoundTexture &other) {
      return other.name == texture.name && other.target == texture.target;
    });
    if (found != bound.end()) {
      texture.unit = found->unit;
      return;
    }
    m_bound.emplace(*context.host, textureTargets()[texture.target].target, GLuint(texture.name),
                    sharingOf(context));
    texture.unit = GLuint(hostInteger(*context.host, GL_ACTIVE_TEXTURE)) - GL_TEXTURE0;
  }
  Rebound(const Rebound &) = delete;
  Rebound &operator=(const Rebound &) = delete;

private:
  std::optional<TextureBinding> m_bound;
};

/// Restores the application's image, unless the application has replaced it since.
void putBack(RasterContext &context, const Session::OwnImage &image) {
  if (image.texture.name != 0 && !context.host->IsTexture(GLuint(image.texture.name)))
    return;
  BoundTexture texture = image.texture;
  const Rebound rebound(context, texture);
  const char *why = nullptr;
  if (readTexture(context, texture, why).bytes == image.written.bytes)
    (void)writeTexture(context, texture, image.own, why);
}

} // namespace

void putBackStale(RasterContext &context, std::vector<Session::OwnImage> &images) {
  std::erase_if(images, [&](const Session::OwnImage &image) {
    if (!image.stale || (!image.group.expired() && !isOf(image, context)))
      return false;
    if (!image.group.expired())
      putBack(context, image);
    return true;
  });
}

wire::Answer textureList(Call &call) {
  Json rows = Json::array();
  for (const BoundTexture &texture : boundTextures(call.context))
    rows.push_back({{"name", texture.name},
                    {"unit", texture.unit},
                    {"target", textureTargets()[texture.target].word},
                    {"width", texture.width},
                    {"height", texture.height},
                    {"depth", texture.depth},
                    {"format", formatName(texture.format)},
                    {"changed", ownImageOf(call.session, call.context, texture) != nullptr}});
  return Json::object({{"textures", std::move(rows)}});
}

wire::Answer textureGet(Call &call) {
  constexpr int kUsual = 128, kMax = 512;
  const int size = int(call.params.integer("size", 1, kMax, kUsual));
  const std::optional<BoundTexture> texture = findTexture(call);
  if (!texture || !call.params.ok())
    return notFound(call);
  const char *why = nullptr;
  Picture picture = readTexture(call.context, *texture, why);
  if (picture.bytes.empty())
    return wire::Fault{wire::kNotPossible, why, {}};
  return Json::object({{"name", texture->name},
                       {"target", textureTargets()[texture->target].word},
                       {"width", texture->width},
                       {"height", texture->height},
                       {"image", imageJson(reduced(std::move(picture), size, size))}});
}

wire::Answer textureSet(Call &call) {
  const std::optional<BoundTexture> texture = findTexture(call);
  if (!texture)
    return notFound(call);
  std::optional<Picture> picture = imageOf(call);
  if (!picture)
    return call.params.fault();
  const char *why = "only formats of 8 bits a component can be replaced";
  if (!holdsBytes(call.context, *texture))
    return wire::Fault{wire::kNotPossible, why, {}};
  Session::OwnImage *image = ownImageOf(call.session, call.context, *texture);
  Picture own;
  if (!image) {
    own = readTexture(call.context, *texture, why);
    if (own.bytes.empty())
      return wire::Fault{wire::kNotPossible, why, {}};
  }
  if (!writeTexture(call.context, *texture, *picture, why))
    return wire::Fault{wire::kNotPossible, why, {}};
  if (!image) {
    call.session.ownImages().push_back(
        {*texture, std::move(own), {}, call.context.group, call.context.serial, false});
    image = &call.session.ownImages().back();
  }
  image->stale = false;
  // Read it back: a format with fewer components keeps less of the picture.
  image->written = readTexture(call.context, *texture, why);
  return Json::object();
}

wire::Answer textureReset(Call &call) {
  const bool one = call.params.has("name");
  const auto name = GLint(call.params.integer("name", 0, INT32_MAX, 0));
  if (!call.params.ok())
    return call.params.fault();
  std::size_t count = 0;
  for (Session::OwnImage &image : call.session.ownImages()) {
    if (one && image.texture.name != name)
      continue;
    image.stale = true;
    ++count;
  }
  putBackStale(call.context, call.session.ownImages());
  return Json::object({{"count", count}});
}

} // namespace arbiter::state::control
