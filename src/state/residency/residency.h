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

namespace arbiter::state {

class NeighbourEpoch;
struct ResidentImages;

/// The current draw framebuffer as images of the layer's.
struct DrawTargets {
  int width = 0, height = 0;                        ///< in pixels; those of the smallest attachment
  swrast::Image *color[abi::kMaxColorTargets] = {}; ///< per draw buffer; null: GL_NONE
  int slice[abi::kMaxColorTargets] = {};            ///< in a 3D texture's image, else 0
  swrast::Image *depthStencil = nullptr;            ///< null: there is none
  int depthBits = 0, stencilBits = 0;
  bool doubleBuffered = false, isWindow = false;
};

/// The unpack state for the application's bitmaps (OpenGL 2.1, 3.6.1 and 3.7).
struct BitUnpacking {
  GLint rowLength = 0, skipRows = 0, skipPixels = 0, alignment = 4;
  bool lowestFirst = false;
  GLuint buffer = 0; ///< the PIXEL_UNPACK_BUFFER to read; 0: client memory
};

/// BASE_LEVEL and MAX_LEVEL of a texture.
struct TextureLevels {
  GLint base = 0, max = 1000;
};
/// A texture for sampling: its levels from BASE_LEVEL on, all valid in shadow.
struct TextureImages {
  abi::Format format;
  abi::Dimension dimension = abi::Dimension::Tex2D;
  bool complete = false;       ///< as `mipmapped` requires; else nothing below is set
  std::uint8_t powerOfTwo = 0; ///< abi::SamplerKey's
  bool srgb = false;           ///< the sampler must decode colours (OpenGL 2.1, 3.8.15)
  abi::TextureView view;       ///< levels and levelCount only; valid until the texture changes
  swrast::Storage *const *storages = nullptr; ///< one per level of view.levels
  int imageCount = 0;                         ///< faces times levels, the size of both arrays
};

/// A texture's properties, without its pixels.
struct TextureFormat {
  abi::Format format; ///< valid if complete
  bool complete = false;
};

/// A copy from the read buffer to a texture. A whole copy shares the shadow, any other copies in
/// memory. Afterwards the texture is pending.
struct CopyToTexture {
  GLuint texture = 0; ///< the bound texture
  GLenum target = 0;  ///< the image target, for instance a face of a cube map
  GLint level = 0;
  bool defines = false; ///< CopyTexImage: (re)defines the level with internalFormat
  GLenum internalFormat = 0;
  GLint border = 0;
  GLint destX = 0, destY = 0, destZ = 0, x = 0, y = 0;
  GLsizei width = 0, height = 1;
};

/// A BlitFramebuffer command, with corners in the order given.
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
  std::uint64_t copiesInMemory = 0;                 ///< feedback copies from shadow to shadow
  std::uint64_t downloads = 0, downloadedBytes = 0; ///< host to shadow
  std::uint64_t uploads = 0, uploadedBytes = 0;     ///< shadow to host
};

/// Keeps a context's images coherent: it knows which copy of each is valid, the host's or the
/// shadow. It moves pixels only when the other side needs them.
///
/// An image is a level of a texture, a renderbuffer or a buffer of the window. It is host-valid (no
/// shadow, or a stale one), valid in both, or shadow-valid ("pending": the host's copy is stale).
/// ContextHot::hostIsBehind is set while any image is pending.
class Residency {
public:
  /// The context's parts that residency uses. All outlive it.
  struct Surroundings {
    ContextHot &hot; ///< current host functions, dirty bits, hostIsBehind
    const HostCaps &caps;
    GLenum &pendingError; ///< for HostErrorScope
    const NeighbourEpoch &neighbours;
    DeletedNames &deletedNames;            ///< of the share group
    TextureViews &textureViews;            ///< of the share group
    const std::atomic<int> &groupContexts; ///< how many the share group ever had
    swrast::PendingDraws &draws;           ///< of the context
    std::uint32_t serial = 0;              ///< of the context, for deletedNames
  };
  explicit Residency(const Surroundings &surroundings);
  ~Residency();
  Residency(const Residency &) = delete;
  Residency &operator=(const Residency &) = delete;

  // --- Targets ---

  /// Describes the current draw framebuffer: sizes and formats, without moving a pixel. Returns
  /// null if the rasterizer cannot draw to it (multisampled, an unsupported format,
  /// GL_FRONT_AND_BACK, incomplete). `reason` then is a row of reasons.def.
  [[nodiscard]] const DrawTargets *describeTargets(const char *&reason);
  /// Returns the last result of describeTargets(), if nothing but the window's size can have
  /// changed since. That size costs reads of the host's buffers, and a test of depth does not need
  /// it. Returns null if more may have changed.
  [[nodiscard]] const DrawTargets *targetsBefore();
  /// Advances when results of describeTargets() or acquireTexture() become invalid. They need not
  /// be called again while it stays the same, syncWithNeighbours() found nothing, and no command
  /// has marked dirty::kFramebuffer.
  [[nodiscard]] std::uint64_t version() const;
  /// True if the shadows can be drawn to right away, as no pixels were moved since
  /// acquireTargets(). Marks them as drawn to. The targets must be as described. Takes no lock.
  [[nodiscard]] bool targetsHeld(bool depthStencilUsed);
  /// Makes the shadows the targets: valid where their contents are kept, writable, and pending.
  /// Returns false without memory; then the host draws.
  /// \param overwritten the area in which the draw surely replaces all colour components
  /// (swrast::surelyCovered)
  /// \param depthUsed, stencilUsed the depth and stencil buffers are read or written
  [[nodiscard]] bool acquireTargets(const swrast::Rect &overwritten, bool depthUsed,
                                    bool stencilUsed);

  // --- Textures ---

  /// Returns the images of the texture `name` that is bound to that target, and downloads what is
  /// stale. Returns null and `reason` if its format is unsupported.
  [[nodiscard]] const TextureImages *acquireTexture(GLuint name, abi::Dimension dimension,
                                                    TextureLevels range, bool mipmapped,
                                                    const char *&reason);
  /// Returns the format that acquireTexture() would give, or nothing if it would fail. Moves no
  /// pixel.
  [[nodiscard]] std::optional<TextureFormat> describeTexture(GLuint name, abi::Dimension dimension,
                                                             TextureLevels range, bool mipmapped);
  /// False if acquireTexture() would refuse the texture's format. Moves no pixel.
  [[nodiscard]] bool samplesTexture(GLuint name, abi::Dimension dimension, TextureLevels range);

  // --- Commands on pixels; if they return false, the host must execute the command ---

  /// Copies between shadows. If it returns false, the host is up to date for the copy and the level
  /// is the host's.
  [[nodiscard]] bool copyToTexture(const CopyToTexture &copy);
  [[nodiscard]] bool clear(GLbitfield mask);
  /// Copies colours from a shadow unchanged or upside down. Reads nothing from the host.
  [[nodiscard]] bool blit(const FramebufferBlit &command);
  /// Returns an identity of the draw framebuffer if Clear of `mask` replaces all its colours and
  /// depths. Null if it does not, or if the rasterizer cannot draw to it.
  [[nodiscard]] const void *wholeTargetCleared(GLbitfield mask);
  [[nodiscard]] bool readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                                GLenum type, void *pixels);
  [[nodiscard]] bool getTexImage(GLenum target, GLint level, GLenum format, GLenum type,
                                 void *pixels);
  /// Follows TexSubImage. Called before the host executes it, which it always does. Writes plain
  /// formats to the shadow too, which stays valid; otherwise the image becomes the host's.
  void texSubImage(GLenum target, GLint level, GLint x, GLint y, GLint z, GLsizei width,
                   GLsizei height, GLsizei depth, GLenum format, GLenum type, const void *pixels);
  /// Follows TexImage2D. Called before the host executes it. If it defines a level as before, it
  /// replaces the texels; otherwise the texture becomes the host's (textureRedefined()).
  void texImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void *pixels);
  /// Makes the texture bound to `target` the host's (0: all textures), after uploading its pending
  /// pixels. Called when a level is (re)defined, storage is given or mipmaps are generated.
  void textureRedefined(GLenum target);
  /// Forgets textures. Called before the host deletes them.
  void texturesDeleted(GLsizei n, const GLuint *names);
  /// Makes the bound renderbuffer the host's, after uploading its pending pixels. Called before the
  /// host gives it storage, or refuses to.
  void renderbufferRedefined();
  /// Forgets renderbuffers. Called before the host deletes them.
  void renderbuffersDeleted(GLsizei n, const GLuint *names);

  // --- The application's pixels in memory ---

  /// Returns the unpack state. Queries the host only after commands that may have changed it and
  /// that pixelStored() does not follow.
  [[nodiscard]] BitUnpacking bitUnpacking();
  /// Follows PixelStore, which the host has executed outside lists and Begin/End. Returns false if
  /// the state must be queried.
  [[nodiscard]] bool pixelStored(GLenum pname, GLint value);

  // --- Synchronisation. `why` is the entry point's name or a reason of reasons.def ---

  /// Uploads all pending images. Shadows stay valid.
  void synchronise(const char *why);
  /// Makes the draw framebuffer's images the host's, after synchronise(). Called before the host
  /// writes to them, by a draw or a clear.
  void hostTakesTargets(const char *why);
  /// Makes every image the host's, after synchronise(). Called before the host does something
  /// unknown.
  void hostDoesAnything(const char *why);

  // --- Frames and contexts ---

  /// Follows Viewport: the window may have another size, which the next draw queries. A new
  /// rectangle suggests that the application heard of one.
  void drawableMayHaveChanged(const swrast::Rect &viewport);
  /// Forgets all images and host state if a neighbour was current (neighbours.h). Called before a
  /// draw looks at state. Returns false while a neighbour is current: the draw and all images are
  /// the host's.
  [[nodiscard]] bool syncWithNeighbours();
  /// Frees images that are no longer valid. The context must not be current meanwhile.
  void forget();
  /// Executes Flush or Finish on the host and makes visible what others may see of the layer's
  /// pixels: single-buffered windows, the memory of OSMesa, textures of several contexts.
  void flush(bool finish);
  /// Presents the window, before SwapBuffers and the like. Returns true if the window system shows
  /// the shadow, so that the host has nothing to swap. Otherwise uploads the pixels. The back
  /// buffer is kept.
  [[nodiscard]] bool present();
  /// Follows a swap that the host is about to do itself. It has all pixels.
  void hostSwaps();
  /// Uploads all pixels before the context leaves the thread or is destroyed while current. Shadows
  /// of a window stay if only contexts that are current with the window can change it. They are
  /// valid again when this context becomes current with it (forgetWindow()).
  void leave();
  /// Drops the window's shadows, as another context becomes current with the window that this one
  /// last had. This context must not be current meanwhile.
  void forgetWindow();
  /// Takes the drawable that the context became current with. Its size and contents may have
  /// changed.
  void enter(const Drawable &drawable);

  [[nodiscard]] const ResidencyStatistics &statistics() const;

private:
  std::unique_ptr<ResidentImages> m_images;
};

} // namespace arbiter::state
