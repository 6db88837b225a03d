#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/capabilities/host_caps.h"
#include "state/core/context_hot.h"
#include "state/core/host_errors.h"
#include "state/objects/neighbour_epoch.h"
#include "state/residency/residency.h"
#include "state/share/deleted_names.h"
#include "state/share/texture_views.h"
#include "swrast/image/image.h"

/// The images that residency keeps: their descriptions, their valid copies, and tables to find
/// them. For the files of residency*.cpp only.
namespace arbiter::state {

enum class Valid : std::uint8_t {
  Host,  ///< the shadow is stale or missing
  Both,  ///< both copies are equal
  Shadow ///< pending: the host's copy is stale
};

/// The TexImage2D that defined a level. Valid while `at` is ObjectImages::descriptions.
struct Definition {
  GLint internalFormat = 0;
  GLenum format = 0, type = 0;
  std::uint64_t at = 0; ///< 0: not defined by TexImage2D, or the host may have refused it
  bool operator==(const Definition &) const = default;
};

/// Names an image for transfers.
struct Place {
  enum class Kind : std::uint8_t { Texture, Renderbuffer, Window } kind = Kind::Texture;
  GLuint name = 0;
  GLenum target = 0; ///< image target of a texture, or GL_BACK, GL_FRONT or GL_DEPTH of a window
  GLint level = 0;
};

struct Texture;

/// One image: a level of a texture's face, a renderbuffer, a buffer of the window.
struct PixelImage {
  Place place;
  Texture *texture = nullptr;         ///< the texture of this level
  const Drawable *drawable = nullptr; ///< the drawable of this colour buffer
  /// Tells whether the description below is valid: for an object while this is
  /// ObjectImages::descriptions, for the window unless this is 0.
  std::uint64_t described = 0;
  GLint internalFormat = 0; ///< as the host reports it
  GLenum base = 0;          ///< GL_RGBA, GL_LUMINANCE .., GL_DEPTH_COMPONENT; 0: not supported
  abi::Format format;       ///< the format of a new shadow
  bool srgb = false;        ///< isSrgb(internalFormat), for supported images
  /// Set for a level that TexImage2D defined after the level was first described.
  Definition definition;
  int width = 0, height = 0, depth = 1;
  /// Its sizes and format are set even while it has no memory. After a copy its format may differ
  /// from `format`, but gives the same RGBA at the same precision.
  swrast::Image shadow;
  Valid valid = Valid::Host;
  std::size_t shadowedAt = 0; ///< index in ObjectImages::shadowed, unless `valid` is Host
  bool listed = false;        ///< in a list of pending images
  bool shown = false;         ///< a window's pixels are on the screen
  bool drawnHere = false;     ///< the rasterizer was the last to write to it
};

/// A texture object, with the faces and levels that were queried.
struct Texture {
  GLuint name = 0;   ///< 0: the default texture of `target`
  GLenum target = 0; ///< 0: unknown
  bool immutable = false, immutableKnown = false;
  std::vector<std::unique_ptr<PixelImage>> images; ///< faces * level + face; null: never queried
  TextureImages view;
  std::array<abi::TextureLevel, 6 * abi::kMaxLevels> levels;
  std::array<swrast::Storage *, 6 * abi::kMaxLevels> storages;
};

/// A context's images of shared objects. Each context has its own, so that none touches what
/// another thread draws with. neighbours.h says how long they are valid.
struct ObjectImages {
  std::unordered_map<std::uint64_t, std::unique_ptr<Texture>> textures; ///< by textureKey()
  std::unordered_map<GLuint, std::unique_ptr<PixelImage>> renderbuffers;
  std::vector<PixelImage *> pending; ///< pending textures and renderbuffers
  /// Advances when a framebuffer's description may be out of date.
  std::uint64_t generation = 1;
  /// Advances when results of describeTargets() or acquireTexture() become invalid: an image got
  /// other memory, another format or size, or became the host's.
  std::uint64_t version = 1;
  /// Advances the version. Call it when a PixelImage gets another shadow.
  void changed() { ++version; }
  /// Images with a valid shadow, windows included, unordered. While it is empty nothing needs to be
  /// done.
  std::vector<PixelImage *> shadowed;
  /// Advances when any image's description may be out of date.
  std::uint64_t descriptions = 1;
  /// Invalidates descriptions, as an image may have been redefined.
  void redefined() {
    ++generation;
    changed();
  }
  bool drawn = false; ///< the rasterizer has ever drawn
  ResidencyStatistics statistics;
  /// Describes the layer's texture that pixels pass through on their way to other images. The share
  /// group has one.
  struct Way {
    GLint width = 0, height = 0, format = 0;
    bool operator==(const Way &) const = default;
  };
  Way way;
};

/// The draw and read framebuffers, as the host reports them.
struct Framebuffers {
  std::uint64_t generation = 0; ///< ObjectImages' generation when queried; 0: never
  GLuint drawName = 0, readName = 0;
  const char *reason = nullptr; ///< why the rasterizer cannot draw to it
  std::array<PixelImage *, abi::kMaxColorTargets> color{};
  std::array<int, abi::kMaxColorTargets> slice{}; ///< the attached slice of each `color`
  PixelImage *depthStencil = nullptr;
  int depthBits = 0, stencilBits = 0;
  int width = 0, height = 0;
  PixelImage *read = nullptr; ///< the read buffer; null: none, or it can have no shadow
  PixelImage *readDepth = nullptr;
  bool readIsWindow = false;
};

/// Pixel store and transfer state; stale while dirty::kPixelStore is set.
struct PixelModes {
  struct Store {
    GLint swapBytes = 0, lsbFirst = 0, rowLength = 0, imageHeight = 0, skipRows = 0, skipPixels = 0,
          skipImages = 0, alignment = 4, invert = 0, buffer = 0;
    bool operator==(const Store &) const = default;
  };
  Store pack, unpack;
  bool transfers = false; ///< colours are scaled, biased or mapped
  bool transfersDepth = false;
};

/// All that residency keeps for a context.
struct ResidentImages {
  explicit ResidentImages(const Residency::Surroundings &around);

  ContextHot &hot;
  const HostCaps &caps;
  GLenum &pendingError;
  const NeighbourEpoch &neighbours;
  DeletedNames &deletedNames;
  TextureViews &textureViews;
  const std::atomic<int> &groupContexts;
  swrast::PendingDraws &draws;
  const std::uint32_t serial;

  Drawable drawable;
  bool released = false; ///< the context left, and the window's shadows stayed
  bool sizeKnown = false, sizeSure = true;
  std::array<swrast::Rect, 4> viewports; ///< the application's last ones, newest first
  std::uint64_t epoch = 0;               ///< of `neighbours`, for which all images are valid; 0:
                                         ///< none
  ObjectImages objects;
  bool doubleBuffered = false;
  PixelImage color, depthStencil;
  int depthBits = 0, stencilBits = 0;
  std::vector<PixelImage *> pending; ///< pending window buffers
  Framebuffers framebuffers;
  DrawTargets targets;
  PixelModes modes;
};

/// Returns a scope whose host errors are the layer's own.
[[nodiscard]] HostErrorScope errorScope(ResidentImages &images);

// --- residency.cpp ---
/// Drops what neighbours may have changed, after uploading what was pending. Each command calls
/// this first; afterwards all images are valid.
void dropIfNeighbourWasCurrent(ResidentImages &images);
/// Calls dropIfNeighbourWasCurrent(), for commands that the host may execute instead. Returns false
/// while a neighbour is current.
[[nodiscard]] bool isAlone(ResidentImages &images);
/// Makes the next use query the window's size, which may have changed.
void forgetSize(ResidentImages &images);

// --- residency_images.cpp ---
/// Returns a key of a texture. Names identify textures, except for 0: each target has its own
/// texture 0 (3.8.12).
[[nodiscard]] constexpr std::uint64_t textureKey(GLenum target, GLuint name) {
  return name != 0 ? name : std::uint64_t(target) << 32;
}
/// Finds or makes the entry of a texture.
/// \param target the texture's own; 0: unknown, for a texture with a name
[[nodiscard]] Texture &textureOf(ObjectImages &objects, GLenum target, GLuint name);
/// Returns the entry of the texture name that is bound to an image's target, if there is one. The
/// bound object may be an older one of that name: see isNamedAsBound().
[[nodiscard]] Texture *textureOfBoundName(ResidentImages &images, GLenum imageTarget);
/// Returns the entry of the texture that is bound to an image's target, if there is one.
[[nodiscard]] Texture *boundTexture(ResidentImages &images, GLenum imageTarget);
/// True if uploads and copies to the bound texture regenerate its other levels (GENERATE_MIPMAP;
/// OpenGL 1.4, 3.8.8). Drawing to it does not.
[[nodiscard]] bool makesMipmaps(const ResidentImages &images, GLenum imageTarget);
/// True if the texture name still exists. Default textures always do.
[[nodiscard]] bool textureExists(const ResidentImages &images, GLuint name);
/// Returns a level's image with its description; null if the target or level does not exist.
[[nodiscard]] PixelImage *levelOf(ResidentImages &images, Texture &texture, GLenum imageTarget,
                                  GLint level);
[[nodiscard]] PixelImage &renderbufferOf(ResidentImages &images, GLuint name);
/// True if the texture that is bound under the name still has it. Otherwise a neighbour deleted it
/// and the name may be another texture's, so it is the host's.
[[nodiscard]] bool isNamedAsBound(const ResidentImages &images, GLuint name);
/// Returns the texture target of an image target: GL_TEXTURE_CUBE_MAP for faces.
[[nodiscard]] GLenum textureTargetOf(GLenum imageTarget);
/// Finds the target of a texture of which only the name is known. Returns 0 if it is not supported.
[[nodiscard]] GLenum findTarget(ResidentImages &images, Texture &texture);
/// True if the image's description is still valid.
[[nodiscard]] inline bool isDescribed(const ObjectImages &objects, const PixelImage &image) {
  return image.described == objects.descriptions;
}
/// Returns a level's image if it was ever queried, whether described or not.
[[nodiscard]] PixelImage *knownLevelOf(Texture &texture, GLenum imageTarget, GLint level);
/// True if TexStorage made the texture, so that its levels are never redefined.
[[nodiscard]] bool isImmutable(ResidentImages &images, Texture &texture);
void setValid(ResidentImages &images, PixelImage &image, Valid which);
/// Frees the shadow's memory. The host's copy must be valid.
void dropShadow(ResidentImages &images, PixelImage &image);
/// Allocates an image, with undefined contents. A window's is in memory that the window system can
/// show, if possible.
[[nodiscard]] swrast::Image makeShadow(const PixelImage &image, const abi::Format &format,
                                       bool topRowFirst);
/// Gives the shadow memory that is its own and writable. \param keep its contents are needed
[[nodiscard]] bool makeOwn(ResidentImages &images, PixelImage &image, bool keep);

// --- residency_formats.cpp ---
/// True if the host stores colours sRGB-encoded (OpenGL 2.1, 3.8.15). They are moved, copied, read
/// and kept in shadows encoded. A sampler may decode them, and a draw may encode.
[[nodiscard]] bool isSrgb(GLint internalFormat);
/// Finds the layer's format for an internal format and component sizes. Returns false if it is
/// unsupported.
struct HostFormat {
  GLint internalFormat = 0;
  GLint red = 0, green = 0, blue = 0, alpha = 0, luminance = 0, intensity = 0, depth = 0,
        stencil = 0;
  GLint type = 0; ///< type of the first component: GL_UNSIGNED_NORMALIZED, GL_FLOAT
  bool compressed = false;
};
[[nodiscard]] bool formatOf(const HostFormat &host, GLenum &base, abi::Format &format);
/// Finds the GL format and type for a transfer that changes no component of `base`. Returns false
/// if pixels must be converted first.
struct GlFormat {
  GLenum format = 0, type = 0;
};
[[nodiscard]] bool glFormatOf(const abi::Format &format, GLenum base, GlFormat &gl);
/// Finds a view of `from` as an image of `base`, if only the order of components differs.
[[nodiscard]] bool viewAs(const abi::Format &from, GLenum base, const abi::Format &wanted,
                          abi::Format &view);
/// True if everything that `base` stores can be written to the format.
[[nodiscard]] bool writable(const abi::Format &format, const abi::Format &canonical);

// --- residency_framebuffer.cpp ---
[[nodiscard]] const Framebuffers &framebuffersOf(ResidentImages &images);
/// Describes the window's buffers at the given size. Framebuffer 0 must be the draw framebuffer.
void describeWindow(ResidentImages &images, int width, int height);

// --- residency_window.cpp ---
/// Describes the window's buffers with the size that the host's have. Called before the host uses
/// them, for the first time since they were bound or a frame ended. A change of size discards their
/// pixels, as it does on the host.
void refreshWindowSize(ResidentImages &images);
/// True if the host may not know that the window's size has changed.
[[nodiscard]] bool hostMissedFrames(const ResidentImages &images);

// --- residency_read.cpp ---
/// Writes all of an 8-bit image to application memory, in rows of `stride` bytes.
void writeApplicationRows(const swrast::Image &image, GLenum format, std::uint8_t *to,
                          std::ptrdiff_t stride, bool topRowFirst);

// --- residency_host.cpp ---
[[nodiscard]] const PixelModes &pixelModes(ResidentImages &images);

// --- residency_transfer.cpp ---
/// Copies the host's pixels to the shadow. Returns false if there is no memory or the host refuses.
[[nodiscard]] bool download(ResidentImages &images, PixelImage &image);
/// Copies the shadow's pixels to the host.
void upload(ResidentImages &images, PixelImage &image);

} // namespace arbiter::state
