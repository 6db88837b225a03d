#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/abi.h"
#include "state/objects/drawable.h"
#include "swrast/image/image.h"
#include "swrast/rect.h"

namespace arbiter::state {
struct ContextHot;
struct HostCaps;
class DeletedNames;
class TextureViews;
} // namespace arbiter::state

namespace arbiter::state::software {

class NeighbourEpoch;
struct ResidentImages;

/// The current draw framebuffer as images of the layer's.
struct DrawTargets {
  int width = 0, height = 0;                        ///< pixels; the smallest attachment's
  swrast::Image *color[abi::kMaxColorTargets] = {}; ///< by draw buffer; null: GL_NONE
  int slice[abi::kMaxColorTargets] = {};            ///< of a 3D texture's image, else 0
  swrast::Image *depthStencil = nullptr;            ///< null: none
  int depthBits = 0, stencilBits = 0;
  bool doubleBuffered = false, isWindow = false;
};

/// How the application's bitmaps lie in memory (OpenGL 2.1, 3.6.1 and 3.7).
struct BitUnpacking {
  GLint rowLength = 0, skipRows = 0, skipPixels = 0, alignment = 4;
  bool lowestFirst = false;
  GLuint buffer = 0; ///< PIXEL_UNPACK_BUFFER that they lie in; 0: client memory
};

/// BASE_LEVEL and MAX_LEVEL of a texture.
struct TextureLevels {
  GLint base = 0, max = 1000;
};
/// A texture as sampled: levels from BASE_LEVEL on, all valid in shadow.
struct TextureImages {
  abi::Format format;
  abi::Dimension dimension = abi::Dimension::Tex2D;
  bool complete = false;       ///< with mipmaps as `mipmapped` asked; else nothing below is set
  std::uint8_t powerOfTwo = 0; ///< abi::SamplerKey's
  bool srgb = false;     ///< colours are encoded, for the sampler to decode (OpenGL 2.1, 3.8.15)
  abi::TextureView view; ///< levels and levelCount only; valid until the texture changes
  swrast::Storage *const *storages = nullptr; ///< of view.levels, one each
  int imageCount = 0;                         ///< of both: faces times levels
};

/// What is known of a texture without its pixels.
struct TextureFormat {
  abi::Format format; ///< of a complete one
  bool complete = false;
};

/// One of the copies from the read buffer to a texture: by sharing the shadow where it is whole, by
/// copying in memory where it is not. The host is then behind with that texture.
struct CopyToTexture {
  GLuint texture = 0; ///< bound to the target
  GLenum target = 0;  ///< of an image: a face of a cube map
  GLint level = 0;
  bool defines = false; ///< CopyTexImage: (re)defines the level with internalFormat
  GLenum internalFormat = 0;
  GLint border = 0;
  GLint destX = 0, destY = 0, destZ = 0, x = 0, y = 0;
  GLsizei width = 0, height = 1;
};

/// BlitFramebuffer: corners as given, either end first.
struct FramebufferBlit {
  struct Corners {
    GLint x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  };
  Corners from, to;
  GLbitfield mask = 0;
  GLenum filter = 0;
};

/// Figures for --stats and for tests.
struct ResidencyStatistics {
  std::uint64_t copiesShared = 0;                   ///< feedback copies that moved no pixel
  std::uint64_t copiesInMemory = 0;                 ///< that copied from shadow to shadow
  std::uint64_t downloads = 0, downloadedBytes = 0; ///< host to shadow
  std::uint64_t uploads = 0, uploadedBytes = 0;     ///< shadow to host
  std::uint64_t shadowBytes = 0;                    ///< held now
};

/// The coherency of a context's images: which copy of each is valid, the host's or our shadow, and
/// moving pixels when the other side needs them. Nothing is moved before that.
///
/// An image (a level of a texture, a renderbuffer, a buffer of the window) is at any moment
/// host-valid (no shadow, or an old one), valid in both (equal), or shadow-valid (the host is
/// behind: "pending"). ContextHot::hostIsBehind is set while any image is pending.
class Residency {
public:
  /// What it is built on, all of which outlives it.
  struct Surroundings {
    ContextHot &hot; ///< the host's functions as they are now, dirty bits, hostIsBehind
    const HostCaps &caps;
    GLenum &pendingError; ///< HostErrorScope
    const NeighbourEpoch &neighbours;
    DeletedNames &deletedNames;            ///< of the share group
    TextureViews &textureViews;            ///< likewise
    const std::atomic<int> &groupContexts; ///< that the share group ever had
    swrast::PendingDraws &draws;           ///< of the context
    std::uint32_t serial = 0;              ///< of the context, for deletedNames
  };
  explicit Residency(const Surroundings &surroundings);
  ~Residency();
  Residency(const Residency &) = delete;
  Residency &operator=(const Residency &) = delete;

  // --- Targets ---

  /// What of the current draw framebuffer is: sizes and formats, without moving a pixel. Null where
  /// we cannot draw to it (multisampled, a format that we lack, GL_FRONT_AND_BACK, incomplete),
  /// with `reason` a row of reasons.def.
  [[nodiscard]] const DrawTargets *describeTargets(const char *&reason);
  /// What describeTargets() told last, where nothing has changed since but for the window's size,
  /// which costs reads of the host's buffers to find out: enough for whether a draw tests depth.
  /// Null where more has changed.
  [[nodiscard]] const DrawTargets *targetsBefore();
  /// Moves on when what describeTargets() or acquireTexture() told is invalidated. While it stands,
  /// syncWithNeighbours() found nothing, and no command has marked dirty::kFramebuffer, they need
  /// not be called again.
  [[nodiscard]] std::uint64_t version() const;
  /// While the targets are as described: true if the shadows are the place to draw to already, as
  /// after acquireTargets() and with nothing in between that moved pixels; they are drawn to then.
  /// Takes no lock.
  [[nodiscard]] bool targetsHeld(bool depthStencilUsed);
  /// Makes the shadows the place to draw to: valid where contents are kept, writable, pending
  /// after. False: no memory; the host draws.
  /// \param overwritten what the draw surely replaces in all its colour components
  /// (swrast::surelyCovered)
  /// \param depthUsed, stencilUsed the depth and stencil buffers are read or written
  [[nodiscard]] bool acquireTargets(const swrast::Rect &overwritten, bool depthUsed,
                                    bool stencilUsed);

  // --- Textures ---

  /// The images of the texture `name` bound to that target, downloaded as far as the host is newer.
  /// Null where its format is one that we lack, with `reason`.
  [[nodiscard]] const TextureImages *acquireTexture(GLuint name, abi::Dimension dimension,
                                                    TextureLevels range, bool mipmapped,
                                                    const char *&reason);
  /// What acquireTexture() would say of the format, or that it would be null; moves no pixel.
  [[nodiscard]] std::optional<TextureFormat> describeTexture(GLuint name, abi::Dimension dimension,
                                                             TextureLevels range, bool mipmapped);
  /// False where acquireTexture() would refuse the texture's format; moves no pixel.
  [[nodiscard]] bool samplesTexture(GLuint name, abi::Dimension dimension, TextureLevels range);

  // --- Commands on pixels; false: the host's, go on as with any other command ---

  /// False: the host has been brought up to date for the copy, and the level is its own.
  [[nodiscard]] bool copyToTexture(const CopyToTexture &copy);
  [[nodiscard]] bool clear(GLbitfield mask);
  /// Colours that are moved as they are, upside down or not, from a shadow; nothing of the host's
  /// is read.
  [[nodiscard]] bool blit(const FramebufferBlit &command);
  /// What tells the draw framebuffer from others, where Clear of `mask` replaces all of its colours
  /// and depths; null where it does not, or where we cannot draw to it.
  [[nodiscard]] const void *wholeTargetCleared(GLbitfield mask);
  [[nodiscard]] bool readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                GLenum type, void *pixels);
  [[nodiscard]] bool getTexImage(GLenum target, GLint level, GLenum format, GLenum type,
                                 void *pixels);
  /// The application replaces texels. The host gets them as always; the shadow too where the
  /// formats are plain, so that it stays valid, and else it is the host's. Called before the host's
  /// own call.
  void texSubImage(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei width,
                   GLsizei height, GLsizei depth, GLenum format, GLenum type, const void *pixels);
  /// Before TexImage2D. Where it defines a level as it is already, it replaces its texels; else the
  /// texture is the host's (textureRedefined()).
  void texImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void *pixels);
  /// A level is (re)defined, storage is given, mipmaps are generated: the texture bound to `target`
  /// (0: any, all of them) is the host's from here on. Pending pixels of it go to the host first.
  void textureRedefined(GLenum target);
  /// Before the host deletes them.
  void texturesDeleted(GLsizei n, const GLuint *names);
  /// Before the host gives storage to the renderbuffer that is bound, or refuses to: the
  /// renderbuffer is the host's from here on. Pending pixels of it go to the host first.
  void renderbufferRedefined();
  /// Before the host deletes them.
  void renderbuffersDeleted(GLsizei n, const GLuint *names);

  // --- The application's pixels in memory ---

  /// Asks the host only after a command that may have changed it, which those of PixelStore are not
  /// that pixelStored() follows.
  [[nodiscard]] BitUnpacking bitUnpacking();
  /// PixelStore went to the host, outside lists and Begin/End: followed, or (false) to be asked
  /// for.
  [[nodiscard]] bool pixelStored(GLenum pname, GLint value);

  // --- Synchronisation. Why the host had to be brought up to date: an entry point's name, or a
  // --- reason of reasons.def ---

  /// All pending images go to the host. Afterwards nothing is pending; shadows stay valid.
  void synchronise(const char *why);
  /// The host is about to write to its draw framebuffer (a draw of the host's, or a clear):
  /// synchronise(), then the framebuffer's images are the host's.
  void hostTakesTargets(const char *why);
  /// The host is about to do something unknown: synchronise(), then every image is the host's.
  void hostDoesAnything(const char *why);

  // --- Frames and contexts ---

  /// Viewport was called: the window may have another size since, and is asked at the next draw. A
  /// rectangle that is new says that the application heard of one.
  void drawableMayHaveChanged(const swrast::Rect &viewport);
  /// Before a draw looks at state: where a neighbour (neighbours.h) was current since, all that is
  /// known of images and of the host's state is forgotten. False while one is current: the draw is
  /// the host's, and so is every image.
  [[nodiscard]] bool syncWithNeighbours();
  /// Gives the memory back of what is not good any more. The context is current to no thread, and
  /// does not become so meanwhile.
  void forget();
  /// The host's Flush or Finish, and around it what others can see of our pixels by then
  /// (single-buffered windows, the application's memory of OSMesa, textures of several contexts).
  void flush(bool finish);
  /// Before SwapBuffers and its kin: the window's pixels are shown by the window system (true: the
  /// host has nothing to swap), or go to the host by the shortest way. The back buffer is kept.
  [[nodiscard]] bool present();
  /// The host is about to swap the drawable's buffers by itself, and all pixels went to it.
  void hostSwaps();
  /// Before the context leaves the thread, or is destroyed while current. The host has all pixels
  /// then. What shadows of a window outlive it: those that only contexts can change which become
  /// current with the window, for when this one does so again (forgetWindow()).
  void leave();
  /// Another context becomes current with the drawable that this one was last current with. It is
  /// current to no thread, and does not become so meanwhile.
  void forgetWindow();
  /// After it became current with the drawable: window sizes and contents may have changed.
  void enter(const Drawable &drawable);

  [[nodiscard]] ResidencyStatistics statistics() const;

private:
  std::unique_ptr<ResidentImages> m_images;
};

} // namespace arbiter::state::software
