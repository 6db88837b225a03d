// Textures as programs sample them, and commands that end a texture's shadow.
#include <algorithm>
#include <bit>

#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state {

namespace {

GLenum targetOf(abi::Dimension dimension) {
  switch (dimension) {
  case abi::Dimension::Tex1D:
    return GL_TEXTURE_1D;
  case abi::Dimension::Tex2D:
    return GL_TEXTURE_2D;
  case abi::Dimension::Tex3D:
    return GL_TEXTURE_3D;
  case abi::Dimension::Cube:
    return GL_TEXTURE_CUBE_MAP;
  case abi::Dimension::Rect:
    return GL_TEXTURE_RECTANGLE;
  }
  return 0;
}

/// Returns a view of an image. Waiting draws may still write to it; it is sampled after them.
abi::TextureLevel viewOf(const swrast::Image &image) {
  if (image.storage->pendingClear())
    image.complete();
  return {.base = image.placeOf(0, 0),
          .rowStride = image.rowStride,
          .sliceStride = image.sliceStride,
          .width = image.width,
          .height = image.height,
          .depth = image.depth};
}

/// The largest image, in bytes, that is downloaded for sampling. Copying a larger one takes longer
/// than the host's draws with it, and doubles its memory. The rasterizer samples larger ones only
/// if it drew them.
constexpr std::int64_t kMaxToCopy = std::int64_t(256) << 20;

/// True if the image's format is supported and it need not be too large a download.
bool isSampledHere(const PixelImage &image) {
  return image.base != 0 &&
         (image.valid != Valid::Host || std::int64_t(image.width) * image.height * image.depth *
                                                abi::bytesOf(image.format.layout) <=
                                            kMaxToCopy);
}

/// Returns the first sampled level; null if the texture is incomplete.
PixelImage *baseLevel(ResidentImages &images, Texture &texture, GLenum target,
                      TextureLevels range) {
  const GLenum first =
      target == GL_TEXTURE_CUBE_MAP ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X) : target;
  PixelImage *const base = levelOf(images, texture, first, range.base);
  return range.base > range.max || !base || base->width <= 0 ? nullptr : base;
}

/// Gathers the sampled levels of a texture, all valid in shadow. It fails for an unsupported
/// format, an image that stays the host's, or lack of memory. `complete` tells whether GL would
/// sample the texture at all (3.8.10).
class Completeness {
public:
  Completeness(ResidentImages &images, Texture &texture) : m_images(images), m_texture(texture) {}

  bool gather(GLenum target, TextureLevels range, bool mipmapped, const char *&reason) {
    TextureImages &view = m_texture.view;
    view = {};
    if (!find(target, range, mipmapped)) {
      reason = "texture";
      return false;
    }
    if (!m_base)
      return true;
    const int faces = m_faces, levels = m_levels;
    const GLenum first = m_first;
    const PixelImage *const base = m_base;
    if (!valid(first, faces, range.base, levels, *base, reason))
      return false;
    for (int level = 0; level < levels; ++level)
      for (int face = 0; face < faces; ++face) {
        const swrast::Image &shadow =
            levelOf(m_images, m_texture, first + GLenum(face), range.base + level)->shadow;
        const auto at = std::size_t(faces * level + face);
        m_texture.levels[at] = viewOf(shadow);
        m_texture.storages[at] = shadow.storage.get();
      }
    view.format = base->shadow.format;
    view.complete = true;
    view.srgb = base->srgb;
    const int sizes[3] = {base->width, base->height, base->depth};
    for (unsigned axis = 0; axis < 3; ++axis)
      if (std::has_single_bit(unsigned(sizes[axis])))
        view.powerOfTwo |= std::uint8_t(1u << axis);
    view.view.levels = m_texture.levels.data();
    view.view.levelCount = levels;
    view.storages = m_texture.storages.data();
    view.imageCount = faces * levels;
    return true;
  }

  /// Finds the levels. Returns false for an unsupported format or an image that stays the host's.
  bool find(GLenum target, TextureLevels range, bool mipmapped) {
    m_faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
    m_first = m_faces == 6 ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X) : target;
    PixelImage *const base = baseLevel(m_images, m_texture, target, range);
    if (!base || !isSampledHere(*base))
      return !base;
    m_levels = 1;
    if (mipmapped) {
      const auto largest = unsigned(std::max({base->width, base->height, base->depth}));
      m_levels = std::min(int(std::bit_width(largest)), range.max - range.base + 1);
    }
    m_levels = std::min(m_levels, abi::kMaxLevels - range.base);
    for (int level = 0; level < m_levels; ++level)
      for (int face = 0; face < m_faces; ++face) {
        PixelImage *const image =
            levelOf(m_images, m_texture, m_first + GLenum(face), range.base + level);
        if (!image || !fits(*image, *base, level, m_faces == 6))
          return true;
      }
    m_base = base;
    return true;
  }
  /// Returns the first level after find(), which has the format of all. Null if the texture is
  /// incomplete.
  [[nodiscard]] const PixelImage *base() const { return m_base; }

private:
  static bool fits(const PixelImage &image, const PixelImage &base, int level, bool cube) {
    const auto size = [level](int of) { return std::max(1, of >> level); };
    return image.internalFormat == base.internalFormat && image.width == size(base.width) &&
           image.height == size(base.height) && image.depth == size(base.depth) &&
           (!cube || image.width == image.height);
  }

  /// Downloads stale shadows and converts all to one format.
  bool valid(GLenum first, int faces, int baseLevel, int levels, const PixelImage &base,
             const char *&reason) {
    bool oneFormat = true;
    for (int pass = 0; pass < 2; ++pass) {
      for (int level = 0; level < levels; ++level)
        for (int face = 0; face < faces; ++face) {
          PixelImage &image =
              *levelOf(m_images, m_texture, first + GLenum(face), baseLevel + level);
          if (pass == 0 && image.valid == Valid::Host && !download(m_images, image)) {
            reason = "memory";
            return false;
          }
          if (pass == 1 && !oneFormat && !own(m_images, image)) {
            reason = "memory";
            return false;
          }
          oneFormat = oneFormat && (pass == 1 || image.shadow.format == base.shadow.format);
        }
    }
    return true;
  }

  static bool own(ResidentImages &images, PixelImage &image) {
    if (image.shadow.format == image.format)
      return true;
    swrast::Image made = swrast::makeImage(image.format, image.width, image.height, image.depth);
    if (made.empty())
      return false;
    for (int z = 0; z < image.depth; ++z)
      swrast::copyPixels(made, 0, 0, z, image.shadow, {0, 0, image.width, image.height}, z);
    image.shadow = std::move(made);
    images.objects.changed();
    return true;
  }

  ResidentImages &m_images;
  Texture &m_texture;
  const PixelImage *m_base = nullptr;
  int m_faces = 1, m_levels = 1;
  GLenum m_first = 0;
};

} // namespace

const TextureImages *Residency::acquireTexture(GLuint name, abi::Dimension dimension,
                                               TextureLevels range, bool mipmapped,
                                               const char *&reason) {
  ResidentImages &images = *m_images;
  reason = "texture";
  const GLenum target = targetOf(dimension);
  // A texture that a neighbour deleted is still sampled here, but its name may be another one's.
  if (!isNamedAsBound(images, name))
    return nullptr;
  Texture &texture = textureOf(images.objects, target, name);
  if (!Completeness(images, texture).gather(target, range, mipmapped, reason))
    return nullptr;
  texture.view.dimension = dimension;
  return &texture.view;
}

std::optional<TextureFormat> Residency::describeTexture(GLuint name, abi::Dimension dimension,
                                                        TextureLevels range, bool mipmapped) {
  ResidentImages &images = *m_images;
  const GLenum target = targetOf(dimension);
  if (!isNamedAsBound(images, name))
    return std::nullopt;
  Completeness completeness(images, textureOf(images.objects, target, name));
  if (!completeness.find(target, range, mipmapped))
    return std::nullopt;
  const PixelImage *const base = completeness.base();
  return base ? TextureFormat{base->shadow.format, true} : TextureFormat{};
}

bool Residency::samplesTexture(GLuint name, abi::Dimension dimension, TextureLevels range) {
  ResidentImages &images = *m_images;
  const GLenum target = targetOf(dimension);
  if (!isNamedAsBound(images, name))
    return false;
  const PixelImage *const base =
      baseLevel(images, textureOf(images.objects, target, name), target, range);
  return !base || isSampledHere(*base);
}

namespace {

/// Forgets a texture's levels, which may be redefined. The host has all its pixels.
void redefine(ResidentImages &images, Texture &texture) {
  texture.immutableKnown = false;
  for (const std::unique_ptr<PixelImage> &image : texture.images)
    if (image) {
      dropShadow(images, *image);
      image->described = 0;
      image->definition = {};
    }
}

/// Uploads an image that is about to become the host's.
void handToHost(ResidentImages &images, PixelImage &image) {
  if (image.valid != Valid::Shadow)
    return;
  upload(images, image);
  setValid(images, image, Valid::Both);
}

} // namespace

void Residency::textureRedefined(GLenum target) {
  ResidentImages &images = *m_images;
  if (!isAlone(images))
    return;
  ObjectImages &objects = images.objects;
  if (objects.textures.empty())
    return;
  const auto redefineOne = [&](Texture &texture) {
    for (const std::unique_ptr<PixelImage> &image : texture.images)
      if (image)
        handToHost(images, *image);
    redefine(images, texture);
  };
  if (target == 0) {
    for (const auto &[key, texture] : objects.textures)
      redefineOne(*texture);
  } else {
    const GLenum binding =
        bindingOf(target == GL_TEXTURE_CUBE_MAP ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X) : target);
    if (binding == 0)
      return; // proxies and array textures have no shadow
    GLint bound = 0;
    images.hot.host->GetIntegerv(binding, &bound);
    const auto found = objects.textures.find(textureKey(textureTargetOf(target), GLuint(bound)));
    if (found != objects.textures.end())
      redefineOne(*found->second);
  }
  objects.redefined();
}

void Residency::texturesDeleted(GLsizei n, const GLuint *names) {
  ResidentImages &images = *m_images;
  if (!isAlone(images) || !names)
    return;
  ObjectImages &objects = images.objects;
  for (GLsizei i = 0; i < n; ++i) {
    const auto found = objects.textures.find(names[i]);
    if (found == objects.textures.end())
      continue;
    // Its images live on where they are attached to a framebuffer that is not bound.
    for (const std::unique_ptr<PixelImage> &image : found->second->images)
      if (image)
        handToHost(images, *image);
    redefine(images, *found->second);
    std::erase_if(objects.pending,
                  [&](const PixelImage *image) { return image->texture == found->second.get(); });
    objects.textures.erase(found);
    objects.redefined();
  }
}

void Residency::renderbufferRedefined() {
  ResidentImages &images = *m_images;
  if (!isAlone(images))
    return;
  ObjectImages &objects = images.objects;
  GLint bound = 0;
  images.hot.host->GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
  if (!images.deletedNames.isUniqueWhereBound(DeletedNames::Kind::Renderbuffer, GLuint(bound),
                                              images.serial))
    return hostDoesAnything("glRenderbufferStorage");
  const auto found = objects.renderbuffers.find(GLuint(bound));
  if (found != objects.renderbuffers.end()) {
    handToHost(images, *found->second); // they stay if the host refuses the storage
    dropShadow(images, *found->second);
    found->second->described = 0;
  }
  objects.redefined();
}

void Residency::renderbuffersDeleted(GLsizei n, const GLuint *names) {
  ResidentImages &images = *m_images;
  if (!isAlone(images) || !names)
    return;
  ObjectImages &objects = images.objects;
  for (GLsizei i = 0; i < n; ++i) {
    const auto found = objects.renderbuffers.find(names[i]);
    if (found == objects.renderbuffers.end())
      continue;
    // It lives on where it is attached to a framebuffer that is not bound.
    PixelImage *const image = found->second.get();
    handToHost(images, *image);
    dropShadow(images, *image);
    std::erase(objects.pending, image);
    objects.renderbuffers.erase(found);
    objects.redefined();
  }
}

} // namespace arbiter::state
