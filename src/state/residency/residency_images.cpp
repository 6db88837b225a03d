// The tables of images, and their descriptions by the host.
#include "state/residency/residency_images.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/residency/residency_host.h"
#include "swrast/image/copy_pixels.h"

namespace arbiter::state {

namespace {

/// Queries a level of the texture that is bound to its target.
void describeLevel(ResidentImages &images, PixelImage &image) {
  const host::HostTable &host = *images.hot.host;
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetTexLevelParameteriv(image.place.target, image.place.level, pname, &value);
    return value;
  };
  image.described = images.objects.descriptions;
  image.width = get(GL_TEXTURE_WIDTH);
  image.height = get(GL_TEXTURE_HEIGHT);
  image.depth = get(GL_TEXTURE_DEPTH);
  image.base = 0;
  image.shadow = {};
  if (image.width <= 0 || image.height <= 0 || image.depth <= 0)
    return;
  HostFormat format;
  format.internalFormat = image.internalFormat = get(GL_TEXTURE_INTERNAL_FORMAT);
  format.red = get(GL_TEXTURE_RED_SIZE);
  format.green = get(GL_TEXTURE_GREEN_SIZE);
  format.blue = get(GL_TEXTURE_BLUE_SIZE);
  format.alpha = get(GL_TEXTURE_ALPHA_SIZE);
  format.luminance = get(GL_TEXTURE_LUMINANCE_SIZE);
  format.intensity = get(GL_TEXTURE_INTENSITY_SIZE);
  format.depth = get(GL_TEXTURE_DEPTH_SIZE);
  format.stencil = get(GL_TEXTURE_STENCIL_SIZE);
  format.compressed = get(GL_TEXTURE_COMPRESSED) != 0;
  format.type = get(format.depth != 0       ? GL_TEXTURE_DEPTH_TYPE
                    : format.luminance != 0 ? GL_TEXTURE_LUMINANCE_TYPE
                    : format.intensity != 0 ? GL_TEXTURE_INTENSITY_TYPE
                    : format.red != 0       ? GL_TEXTURE_RED_TYPE
                                            : GL_TEXTURE_ALPHA_TYPE);
  // Sizes count the texels of a border, and sampling treats them differently.
  if (get(GL_TEXTURE_BORDER) != 0 || !formatOf(format, image.base, image.format)) {
    image.base = 0;
    return;
  }
  image.srgb = isSrgb(image.internalFormat);
  image.shadow.format = image.format;
  image.shadow.width = image.width;
  image.shadow.height = image.height;
  image.shadow.depth = image.depth;
}

int faceOf(GLenum imageTarget) {
  return imageTarget >= GL_TEXTURE_CUBE_MAP_POSITIVE_X &&
                 imageTarget <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z
             ? int(imageTarget - GL_TEXTURE_CUBE_MAP_POSITIVE_X)
             : 0;
}

} // namespace

ResidentImages::ResidentImages(const Residency::Surroundings &around)
    : hot(around.hot), caps(around.caps), pendingError(around.pendingError),
      neighbours(around.neighbours), deletedNames(around.deletedNames),
      textureViews(around.textureViews), groupContexts(around.groupContexts), draws(around.draws),
      serial(around.serial) {}

HostErrorScope errorScope(ResidentImages &images) {
  return HostErrorScope(*images.hot.host, images.pendingError);
}

bool isNamedAsBound(const ResidentImages &images, GLuint name) {
  return images.deletedNames.isUniqueWhereBound(DeletedNames::Kind::Texture, name, images.serial);
}

Texture &textureOf(ObjectImages &objects, GLenum target, GLuint name) {
  const std::uint64_t key = textureKey(target, name);
  const auto found = objects.textures.find(key);
  if (found != objects.textures.end())
    return *found->second;
  auto made = std::make_unique<Texture>();
  made->name = name;
  made->target = name != 0 ? 0 : target;
  return *objects.textures.emplace(key, std::move(made)).first->second;
}

Texture *textureOfBoundName(ResidentImages &images, GLenum imageTarget) {
  GLint name = 0;
  images.hot.host->GetIntegerv(bindingOf(imageTarget), &name);
  const auto &textures = images.objects.textures;
  const auto found = textures.find(textureKey(textureTargetOf(imageTarget), GLuint(name)));
  return found == textures.end() ? nullptr : found->second.get();
}

Texture *boundTexture(ResidentImages &images, GLenum imageTarget) {
  Texture *const texture = textureOfBoundName(images, imageTarget);
  return texture && isNamedAsBound(images, texture->name) ? texture : nullptr;
}

bool makesMipmaps(const ResidentImages &images, GLenum imageTarget) {
  GLint made = 0;
  images.hot.host->GetTexParameteriv(textureTargetOf(imageTarget), GL_GENERATE_MIPMAP, &made);
  return made != 0;
}

bool textureExists(const ResidentImages &images, GLuint name) {
  return name == 0 || images.hot.host->IsTexture(name) != GL_FALSE;
}

GLenum textureTargetOf(GLenum imageTarget) {
  switch (imageTarget) {
  case GL_TEXTURE_1D:
  case GL_TEXTURE_2D:
  case GL_TEXTURE_3D:
  case GL_TEXTURE_RECTANGLE:
  case GL_TEXTURE_CUBE_MAP:
    return imageTarget;
  default:
    return imageTarget >= GL_TEXTURE_CUBE_MAP_POSITIVE_X &&
                   imageTarget <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z
               ? GL_TEXTURE_CUBE_MAP
               : 0;
  }
}

GLenum findTarget(ResidentImages &images, Texture &texture) {
  if (texture.target != 0)
    return texture.target;
  const host::HostTable &host = *images.hot.host;
  HostErrorScope errors = errorScope(images);
  // A texture belongs to the target that it was first bound to. Binding it to another is an error
  // without effect.
  for (const GLenum target :
       {GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D, GL_TEXTURE_1D}) {
    const TextureBinding binding = bindTexture(images, target, texture.name);
    GLint bound = 0;
    host.GetIntegerv(bindingOf(target == GL_TEXTURE_CUBE_MAP
                                   ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X)
                                   : GLenum(target)),
                     &bound);
    if (GLuint(bound) == texture.name) {
      texture.target = target;
      break;
    }
  }
  return texture.target;
}

PixelImage *levelOf(ResidentImages &images, Texture &texture, GLenum imageTarget, GLint level) {
  const GLenum target = textureTargetOf(imageTarget);
  if (target == 0 || level < 0 || level >= abi::kMaxLevels)
    return nullptr;
  if (texture.target == 0)
    texture.target = target;
  if (texture.target != target)
    return nullptr;
  const int faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
  const auto index = std::size_t(faces * level + faceOf(imageTarget));
  if (index >= texture.images.size())
    texture.images.resize(index + 1);
  std::unique_ptr<PixelImage> &image = texture.images[index];
  if (!image) {
    image = std::make_unique<PixelImage>();
    image->place = {Place::Kind::Texture, texture.name, imageTarget, level};
    image->texture = &texture;
  }
  if (!isDescribed(images.objects, *image)) {
    HostErrorScope errors = errorScope(images);
    const TextureBinding binding = bindTexture(images, target, texture.name);
    describeLevel(images, *image);
    if (images.textureViews.contains(texture.name)) {
      image->base = 0;
      image->shadow = {};
    }
  }
  return image.get();
}

PixelImage *knownLevelOf(Texture &texture, GLenum imageTarget, GLint level) {
  const GLenum target = textureTargetOf(imageTarget);
  if (target == 0 || texture.target != target || level < 0 || level >= abi::kMaxLevels)
    return nullptr;
  const int faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
  const auto index = std::size_t(faces * level + faceOf(imageTarget));
  return index < texture.images.size() ? texture.images[index].get() : nullptr;
}

bool isImmutable(ResidentImages &images, Texture &texture) {
  if (!texture.immutableKnown) {
    const TextureBinding bound = bindTexture(images, texture.target, texture.name);
    GLint immutable = 0;
    HostErrorScope errors = errorScope(images);
    images.hot.host->GetTexParameteriv(texture.target, GL_TEXTURE_IMMUTABLE_FORMAT, &immutable);
    texture.immutable = immutable != 0;
    texture.immutableKnown = true;
  }
  return texture.immutable;
}

namespace {

/// Returns the type of a renderbuffer's components, GL_FLOAT or GL_UNSIGNED_NORMALIZED; 0 for
/// others. Only an attachment has a query for it, so the format's name tells.
GLint componentTypeOf(GLint internalFormat) {
  switch (internalFormat) {
  case GL_RGBA32F:
  case GL_RGB32F:
  case GL_RG32F:
  case GL_R32F:
  case GL_RGBA16F:
  case GL_RGB16F:
  case GL_RG16F:
  case GL_R16F:
  case GL_DEPTH_COMPONENT32F:
  case GL_DEPTH32F_STENCIL8:
    return GL_FLOAT;
  case GL_RGBA:
  case GL_RGBA8:
  case GL_RGB:
  case GL_RGB8:
  case GL_SRGB8:
  case GL_SRGB8_ALPHA8:
  case GL_RG8:
  case GL_R8:
  case GL_RG:
  case GL_RED:
  case GL_RGBA16:
  case GL_RGB16:
  case GL_RG16:
  case GL_R16:
  case GL_RGB4:
  case GL_RGB5:
  case GL_RGB565:
  case GL_RGB10:
  case GL_RGB12:
  case GL_RGBA2:
  case GL_RGBA4:
  case GL_RGB5_A1:
  case GL_RGB10_A2:
  case GL_RGBA12:
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_COMPONENT16:
  case GL_DEPTH_COMPONENT24:
  case GL_DEPTH_COMPONENT32:
  case GL_DEPTH_STENCIL:
  case GL_DEPTH24_STENCIL8:
    return GL_UNSIGNED_NORMALIZED;
  default:
    return 0; // integers and signed values
  }
}

} // namespace

PixelImage &renderbufferOf(ResidentImages &images, GLuint name) {
  auto &renderbuffers = images.objects.renderbuffers;
  auto found = renderbuffers.find(name);
  if (found == renderbuffers.end()) {
    auto made = std::make_unique<PixelImage>();
    made->place = {Place::Kind::Renderbuffer, name, GL_RENDERBUFFER, 0};
    found = renderbuffers.emplace(name, std::move(made)).first;
  }
  PixelImage *const image = found->second.get();
  if (isDescribed(images.objects, *image))
    return *image;
  const host::HostTable &host = *images.hot.host;
  HostErrorScope errors = errorScope(images);
  GLint previous = 0;
  host.GetIntegerv(GL_RENDERBUFFER_BINDING, &previous);
  // The previous renderbuffer cannot be bound again if another context deleted its name. Then the
  // host draws.
  if (!images.deletedNames.isUniqueWhereBound(DeletedNames::Kind::Renderbuffer, GLuint(previous),
                                              images.serial))
    return *image;
  host.BindRenderbuffer(GL_RENDERBUFFER, name);
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    host.GetRenderbufferParameteriv(GL_RENDERBUFFER, pname, &value);
    return value;
  };
  image->described = images.objects.descriptions;
  image->width = get(GL_RENDERBUFFER_WIDTH);
  image->height = get(GL_RENDERBUFFER_HEIGHT);
  HostFormat format;
  format.internalFormat = image->internalFormat = get(GL_RENDERBUFFER_INTERNAL_FORMAT);
  format.red = get(GL_RENDERBUFFER_RED_SIZE);
  format.green = get(GL_RENDERBUFFER_GREEN_SIZE);
  format.blue = get(GL_RENDERBUFFER_BLUE_SIZE);
  format.alpha = get(GL_RENDERBUFFER_ALPHA_SIZE);
  format.depth = get(GL_RENDERBUFFER_DEPTH_SIZE);
  format.stencil = get(GL_RENDERBUFFER_STENCIL_SIZE);
  const GLint samples = get(GL_RENDERBUFFER_SAMPLES);
  host.BindRenderbuffer(GL_RENDERBUFFER, GLuint(previous));
  format.type = componentTypeOf(format.internalFormat);
  image->base = 0;
  image->shadow = {};
  if (samples != 0 || image->width <= 0 || image->height <= 0 ||
      !formatOf(format, image->base, image->format)) {
    image->base = 0;
    return *image;
  }
  image->srgb = isSrgb(image->internalFormat);
  image->shadow.format = image->format;
  image->shadow.width = image->width;
  image->shadow.height = image->height;
  return *image;
}

void setValid(ResidentImages &images, PixelImage &image, Valid which) {
  ObjectImages &objects = images.objects;
  const bool isPending = which == Valid::Shadow && !image.listed;
  if (isPending) // before any change, as it may find no memory
    (image.place.kind == Place::Kind::Window ? images.pending : objects.pending).push_back(&image);
  if ((image.valid == Valid::Host) != (which == Valid::Host)) {
    if (which == Valid::Host) {
      PixelImage *const last = objects.shadowed.back();
      last->shadowedAt = image.shadowedAt;
      objects.shadowed[image.shadowedAt] = last;
      objects.shadowed.pop_back();
    } else {
      image.shadowedAt = objects.shadowed.size();
      objects.shadowed.push_back(&image);
    }
    objects.changed();
  }
  image.valid = which;
  image.shown = false;
  if (which != Valid::Shadow)
    return;
  images.hot.hostIsBehind = true;
  image.listed = true;
}

void dropShadow(ResidentImages &images, PixelImage &image) {
  setValid(images, image, Valid::Host);
  image.drawnHere = false;
  image.shadow.storage.reset();
  image.shadow.format = image.format;
}

swrast::Image makeShadow(const PixelImage &image, const abi::Format &format, bool topRowFirst) {
  if (image.drawable && image.drawable->sharedMemory && topRowFirst) {
    const std::int64_t row =
        (std::int64_t(image.width) * abi::bytesOf(format.layout) + 63) & ~std::int64_t(63);
    swrast::Image shared;
    shared.storage =
        image.drawable->sharedMemory(*image.drawable, std::size_t(row) * std::size_t(image.height));
    if (!shared.empty()) {
      shared.format = format;
      shared.width = image.width;
      shared.height = image.height;
      shared.rowStride = -row;
      shared.sliceStride = row * image.height;
      shared.offset = row * (image.height - 1);
      return shared;
    }
  }
  return swrast::makeImage(format, image.width, image.height, image.depth, topRowFirst);
}

bool makeOwn(ResidentImages &images, PixelImage &image, bool keep) {
  swrast::Image &shadow = image.shadow;
  const bool fits = !shadow.empty() && writable(shadow.format, image.format);
  const bool read = fits && shadow.storage->isRead();
  if (fits && !shadow.shared() && !read) {
    if (!keep)
      shadow.storage->forgetClear();
    return true;
  }
  images.objects.changed();
  const bool isWindow = image.place.kind == Place::Kind::Window;
  // Fresh memory is available before the window system has read this, but a copy would not be
  // faster.
  const bool taken = shadow.shared() || (!keep && read);
  if (fits && (!taken || (keep && !isWindow)))
    return swrast::makeWritable(shadow, keep);
  // Keep the order of components that the caller knows, if it can be written.
  const abi::Format format = writable(shadow.format, image.format) ? shadow.format : image.format;
  swrast::Image made = makeShadow(image, format, isWindow);
  if (made.empty())
    return false;
  if (keep && !shadow.empty())
    for (int z = 0; z < image.depth; ++z)
      swrast::copyPixels(made, 0, 0, z, shadow, {0, 0, image.width, image.height}, z);
  shadow = std::move(made);
  return true;
}

} // namespace arbiter::state
