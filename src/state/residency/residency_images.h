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

/// The images that residency keeps: what each is, which copy of it is valid, and the tables that
/// find them. For the files of residency*.cpp only.
namespace arbiter::state::software {

enum class Valid : std::uint8_t {
  Host,  ///< there is no shadow that counts
  Both,  ///< equal
  Shadow ///< pending: the host is behind
};

/// What TexImage2D defined a level with, and when: while that is ObjectImages::descriptions.
struct Definition {
  GLint internalFormat = 0;
  GLenum format = 0, type = 0;
  std::uint64_t at = 0; ///< 0: it did not, or the host might refuse it
  bool operator==(const Definition &) const = default;
};

/// How an image is named when its pixels are moved.
struct Place {
  enum class Kind : std::uint8_t { Texture, Renderbuffer, Window } kind = Kind::Texture;
  GLuint name = 0;
  GLenum target = 0; ///< image target of a texture; of a window GL_BACK, GL_FRONT or GL_DEPTH
  GLint level = 0;
};

struct Texture;

/// One image: a face's level of a texture, a renderbuffer, a buffer of the window.
struct PixelImage {
  Place place;
  Texture *texture = nullptr;         ///< that it is a level of
  const Drawable *drawable = nullptr; ///< that it is the colour buffer of
  /// When the host was asked what it is, which is what follows: of an image of an object while this
  /// is ObjectImages::descriptions, of the window's unless it is 0.
  std::uint64_t described = 0;
  GLint internalFormat = 0; ///< as the host tells it
  GLenum base = 0;    ///< GL_RGBA, GL_LUMINANCE .., GL_DEPTH_COMPONENT; 0: not one that we have
  abi::Format format; ///< that a shadow of it has at first
  bool srgb = false;  ///< isSrgb(internalFormat), of an image that we have
  /// Of a level that TexImage2D defined since it was first known.
  Definition definition;
  int width = 0, height = 0, depth = 1;
  /// Sizes and format are set even while there are no pixels. The format may differ from `format`
  /// after a copy: it then gives the same RGBA at the same precision.
  swrast::Image shadow;
  Valid valid = Valid::Host;
  std::size_t shadowedAt = 0; ///< in ObjectImages::shadowed, while `valid` is not Host
  bool listed = false;        ///< in a list of pending images
  bool shown = false;         ///< of the window: others see these pixels already
  bool drawnHere = false;     ///< by us, since the host last wrote to it
};

/// A texture object; faces and levels as far as they were asked for.
struct Texture {
  GLuint name = 0;   ///< 0: the default texture of `target`
  GLenum target = 0; ///< 0: not known yet
  bool immutable = false, immutableKnown = false;
  std::vector<std::unique_ptr<PixelImage>> images; ///< faces * level + face; null: never asked for
  TextureImages view;
  std::array<abi::TextureLevel, 6 * abi::kMaxLevels> levels;
  std::array<swrast::Storage *, 6 * abi::kMaxLevels> storages;
};

/// A context's images of what its group shares. Each context keeps its own, so that none touches
/// what another thread draws with; neighbours.h says for how long they are good.
struct ObjectImages {
  std::unordered_map<std::uint64_t, std::unique_ptr<Texture>> textures; ///< by textureKey()
  std::unordered_map<GLuint, std::unique_ptr<PixelImage>> renderbuffers;
  std::vector<PixelImage *> pending; ///< textures and renderbuffers
  /// Moves on when an image may be another than a framebuffer's description says.
  std::uint64_t generation = 1;
  /// Moves on when what describeTargets() or acquireTexture() told is invalidated: an image
  /// has other memory, another format or size, or its pixels are the host's.
  std::uint64_t version = 1;
  /// To be called where a PixelImage gets another shadow.
  void changed() { ++version; }
  /// Images whose shadow counts, windows' included, in no order: while there are none, nothing is
  /// to be done.
  std::vector<PixelImage *> shadowed;
  /// Moves on when any image may be another than it was described as.
  std::uint64_t descriptions = 1;
  /// An image may be another than it was described as.
  void redefined() {
    ++generation;
    changed();
  }
  bool drawn = false; ///< by us, ever
  ResidencyStatistics statistics;
  /// What the texture of the layer's is that pixels go through on their way to other images; the
  /// group has one.
  struct Way {
    GLint width = 0, height = 0, format = 0;
    bool operator==(const Way &) const = default;
  };
  Way way;
};

/// The draw and read framebuffers, as the host tells.
struct Framebuffers {
  std::uint64_t generation = 0; ///< of ObjectImages when it was asked; 0: never
  GLuint drawName = 0, readName = 0;
  const char *reason = nullptr; ///< why the rasterizer cannot draw to it
  std::array<PixelImage *, abi::kMaxColorTargets> color{};
  std::array<int, abi::kMaxColorTargets> slice{}; ///< of `color`, the one that is attached
  PixelImage *depthStencil = nullptr;
  int depthBits = 0, stencilBits = 0;
  int width = 0, height = 0;
  PixelImage *read = nullptr; ///< the read buffer; null: none, or one that has no shadow
  PixelImage *readDepth = nullptr;
  bool readIsWindow = false;
};

/// Pixel store and transfer, asked for while dirty::kPixelStore is set.
struct PixelModes {
  struct Store {
    GLint swapBytes = 0, lsbFirst = 0, rowLength = 0, imageHeight = 0, skipRows = 0, skipPixels = 0,
          skipImages = 0, alignment = 4, invert = 0, buffer = 0;
    bool operator==(const Store &) const = default;
  };
  Store pack, unpack;
  bool transfers = false; ///< scales, biases or maps colours
  bool transfersDepth = false;
};

/// All that a context keeps.
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
  bool released = false; ///< left with what outlives that in the window's images
  bool sizeKnown = false, sizeSure = true;
  std::array<swrast::Rect, 4> viewports; ///< that the application used last, the newest first
  std::uint64_t epoch = 0;               ///< of `neighbours`, that all images are good for; 0: none
  ObjectImages objects;
  bool doubleBuffered = false;
  PixelImage color, depthStencil;
  int depthBits = 0, stencilBits = 0;
  std::vector<PixelImage *> pending; ///< of the two
  Framebuffers framebuffers;
  DrawTargets targets;
  PixelModes modes;
};

/// Errors of the host's within it are the layer's.
[[nodiscard]] HostErrorScope errorScope(ResidentImages &images);

// --- residency.cpp ---
/// All images are good then: what neighbours may have changed since is the host's, which was given
/// what was pending. Each command begins with this.
void dropIfNeighbourWasCurrent(ResidentImages &images);
/// The same of a command that the host does as well: false while a neighbour is current.
[[nodiscard]] bool isAlone(ResidentImages &images);
/// The window may have another size: it is asked for before the next use.
void forgetSize(ResidentImages &images);

// --- residency_images.cpp ---
/// Names tell textures apart but for 0, which each target has a texture of (3.8.12).
[[nodiscard]] constexpr std::uint64_t textureKey(GLenum target, GLuint name) {
  return name != 0 ? name : std::uint64_t(target) << 32;
}
/// \param target the texture's own; 0: not known, of one that has a name
[[nodiscard]] Texture &textureOf(ObjectImages &objects, GLenum target, GLuint name);
/// The texture that has the name of what is bound to the target of an image, if anything is known
/// of it. What is bound may be another one, that had the name before: isNamedAsBound().
[[nodiscard]] Texture *textureOfBoundName(ResidentImages &images, GLenum imageTarget);
/// The texture that is bound to the target of an image, if anything is known of it.
[[nodiscard]] Texture *boundTexture(ResidentImages &images, GLenum imageTarget);
/// The texture that is bound to the target of an image makes its other levels anew when texels of
/// it are given or copied (GENERATE_MIPMAP; OpenGL 1.4, 3.8.8). To draw to it does not.
[[nodiscard]] bool makesMipmaps(const ResidentImages &images, GLenum imageTarget);
/// There is a texture of that name still; default textures are always there.
[[nodiscard]] bool textureExists(const ResidentImages &images, GLuint name);
/// The level's image, its description asked for; null for a target or level that there is not.
[[nodiscard]] PixelImage *levelOf(ResidentImages &images, Texture &texture, GLenum imageTarget,
                                  GLint level);
[[nodiscard]] PixelImage &renderbufferOf(ResidentImages &images, GLuint name);
/// A texture that is bound under that name has it still. Else a neighbour deleted it, and the name
/// may be another one's: it is the host's.
[[nodiscard]] bool isNamedAsBound(const ResidentImages &images, GLuint name);
/// The texture's own target of one of an image: GL_TEXTURE_CUBE_MAP for its faces.
[[nodiscard]] GLenum textureTargetOf(GLenum imageTarget);
/// Finds out a texture's target where only its name is known. 0: none that we know.
[[nodiscard]] GLenum findTarget(ResidentImages &images, Texture &texture);
/// What was asked of an image of an object holds still.
[[nodiscard]] inline bool isDescribed(const ObjectImages &objects, const PixelImage &image) {
  return image.described == objects.descriptions;
}
/// The level's image if it was ever asked for, described or not.
[[nodiscard]] PixelImage *knownLevelOf(Texture &texture, GLenum imageTarget, GLint level);
/// The texture was given by TexStorage: its levels are never defined anew.
[[nodiscard]] bool isImmutable(ResidentImages &images, Texture &texture);
void setValid(ResidentImages &images, PixelImage &image, Valid which);
/// The shadow's memory is given back: the host has all.
void dropShadow(ResidentImages &images, PixelImage &image);
/// Memory for all of it, contents undefined; of a window where the window system can show it.
[[nodiscard]] swrast::Image makeShadow(const PixelImage &image, const abi::Format &format,
                                       bool topRowFirst);
/// A shadow with memory of its own that may be written. \param keep its contents are needed
[[nodiscard]] bool makeOwn(ResidentImages &images, PixelImage &image, bool keep);

// --- residency_formats.cpp ---
/// The host holds colours as sRGB encodes them (OpenGL 2.1, 3.8.15). They are moved, copied and
/// read as they are held, and so shadows have them: what samples them may decode, what draws may
/// encode.
[[nodiscard]] bool isSrgb(GLint internalFormat);
/// What `internalFormat` with these component sizes is to us. False: not one that we have.
struct HostFormat {
  GLint internalFormat = 0;
  GLint red = 0, green = 0, blue = 0, alpha = 0, luminance = 0, intensity = 0, depth = 0,
        stencil = 0;
  GLint type = 0; ///< of the first component: GL_UNSIGNED_NORMALIZED, GL_FLOAT
  bool compressed = false;
};
[[nodiscard]] bool formatOf(const HostFormat &host, GLenum &base, abi::Format &format);
/// How the host is told of pixels in this format: exact, without a change of any component that an
/// image of `base` has. False: it must be converted first.
struct GlFormat {
  GLenum format = 0, type = 0;
};
[[nodiscard]] bool glFormatOf(const abi::Format &format, GLenum base, GlFormat &gl);
/// `from` as an image of `base`, if only the order of components must change (same precision).
[[nodiscard]] bool viewAs(const abi::Format &from, GLenum base, const abi::Format &wanted,
                          abi::Format &view);
/// True if all that `base` stores can be written to the format.
[[nodiscard]] bool writable(const abi::Format &format, const abi::Format &canonical);

// --- residency_framebuffer.cpp ---
[[nodiscard]] const Framebuffers &framebuffersOf(ResidentImages &images);
/// Of the window's buffers all but their size; framebuffer 0 is bound to draw to.
void describeWindow(ResidentImages &images, int width, int height);

// --- residency_window.cpp ---
/// Before the host reads or writes the window's buffers, the first time since it was bound or a
/// frame ended: describes them, with the size that the host's have. Pixels of another size are
/// gone, as they are from the host.
void refreshWindowSize(ResidentImages &images);
/// The host does not know that the window may have another size since.
[[nodiscard]] bool hostMissedFrames(const ResidentImages &images);

// --- residency_read.cpp ---
/// All of an 8-bit image, in rows of `stride` bytes of the application's.
void writeApplicationRows(const swrast::Image &image, GLenum format, std::uint8_t *to,
                          std::ptrdiff_t stride, bool topRowFirst);

// --- residency_host.cpp ---
[[nodiscard]] const PixelModes &pixelModes(ResidentImages &images);

// --- residency_transfer.cpp ---
/// The shadow gets what the host has. False: no memory, or the host refused.
[[nodiscard]] bool download(ResidentImages &images, PixelImage &image);
/// The host gets what the shadow has.
void upload(ResidentImages &images, PixelImage &image);

} // namespace arbiter::state::software
