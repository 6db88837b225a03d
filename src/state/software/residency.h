#pragma once
#include <cstdint>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/abi.h"
#include "state/software/drawable.h"
#include "swrast/image.h"

/// Who holds the newest pixels of each image, the host or our shadow, and moving them when the
/// other one needs them. Nothing is moved before that.
///
/// An image (a level of a texture, a renderbuffer, a buffer of the window) is at any moment: host's
/// (no shadow, or an old one), both (equal), or shadow's (the host is behind: "pending").
/// ContextHot::hostIsBehind is set while any image of the context's group is pending.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::software {

// --- Targets
// --------------------------------------------------------------------------------------

/// The current draw framebuffer as images of ours.
struct DrawTargets {
  int width = 0, height = 0;                        ///< pixels; the smallest attachment's
  swrast::Image *color[abi::kMaxColorTargets] = {}; ///< by draw buffer; null: GL_NONE
  int slice[abi::kMaxColorTargets] = {};            ///< of a 3D texture's image, else 0
  swrast::Image *depthStencil = nullptr;            ///< null: none
  int depthBits = 0, stencilBits = 0;
  bool doubleBuffered = false, isWindow = false;
};
/// What of the current draw framebuffer is: sizes and formats, without moving a pixel. Null where
/// we cannot draw to it (multisampled, a format that we lack, GL_FRONT_AND_BACK, incomplete), with
/// `reason` a row of reasons.def.
[[nodiscard]] const DrawTargets *describeTargets(Context &context, const char *&reason);
/// Moves on when what describeTargets() or acquireTexture() told may be otherwise now. While it
/// stands, settle() found nothing, and no command has marked stale::kFramebuffer, they need not be
/// called again.
[[nodiscard]] std::uint64_t imagesVersion(const Context &context);
/// While the targets are as described: true if the shadows are the place to draw to already, as
/// after acquireTargets() and with nothing in between that moved pixels; they are drawn to then.
/// Takes no lock.
[[nodiscard]] bool targetsHeld(Context &context, bool depthStencilUsed);
/// Makes the shadows the place to draw to: valid where contents are kept, writable, pending after.
/// \param overwritten what the draw surely replaces in all its colour components
/// (swrast::surelyCovered) \param depthUsed, stencilUsed  the depth and stencil buffers are read or
/// written False: no memory; the host draws.
[[nodiscard]] bool acquireTargets(Context &context, const swrast::Rect &overwritten, bool depthUsed,
                                  bool stencilUsed);

// --- Textures
// -------------------------------------------------------------------------------------

/// A texture as sampled: levels from BASE_LEVEL on, all valid in shadow.
struct TextureImages {
  abi::Format format;
  abi::Dimension dimension = abi::Dimension::Tex2D;
  bool complete = false; ///< with mipmaps as `mipmapped` asked; else nothing below is set
  bool powerOfTwo = false;
  abi::TextureView view; ///< levels and levelCount only; valid until the texture changes
};
/// The images of the texture `name` bound to that target, downloaded as far as the host is newer.
/// Null where its format is one that we lack, with `reason`.
[[nodiscard]] const TextureImages *acquireTexture(Context &context, GLuint name,
                                                  abi::Dimension dimension, bool mipmapped,
                                                  const char *&reason);

// --- Commands on pixels; false: not ours, go on as with any other command
// ----------------------------

/// One of the copies from the read buffer to a texture: by sharing the shadow where it is whole, by
/// copying in memory where it is not. The host is then behind with that texture.
struct CopyToTexture {
  GLenum target = 0;
  GLint level = 0;
  bool defines = false; ///< CopyTexImage: (re)defines the level with internalFormat
  GLenum internalFormat = 0;
  GLint border = 0;
  GLint destX = 0, destY = 0, destZ = 0, x = 0, y = 0;
  GLsizei width = 0, height = 1;
};
[[nodiscard]] bool copyToTexture(Context &context, const CopyToTexture &copy);
[[nodiscard]] bool clear(Context &context, GLbitfield mask);
/// What tells the draw framebuffer from others, where Clear of `mask` replaces all of its colours
/// and depths; null where it does not, or where we cannot draw to it.
[[nodiscard]] const void *wholeTargetCleared(Context &context, GLbitfield mask);
[[nodiscard]] bool readPixels(Context &context, GLint x, GLint y, GLsizei width, GLsizei height,
                              GLenum format, GLenum type, void *pixels);
[[nodiscard]] bool getTexImage(Context &context, GLenum target, GLint level, GLenum format,
                               GLenum type, void *pixels);
/// The application replaces texels. The host gets them as always; the shadow too where the formats
/// are plain, so that it stays valid, and else it is the host's. Called before the host's own call.
void texSubImage(Context &context, GLenum target, GLint level, GLint x, GLint y, GLint z,
                 GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type,
                 const void *pixels);
/// A level is (re)defined, storage is given, mipmaps are generated: the texture bound to `target`
/// (0: any, all of them) is the host's from here on. Pending pixels of it go to the host first.
void textureRedefined(Context &context, GLenum target);
/// Before the host deletes them.
void texturesDeleted(Context &context, GLsizei n, const GLuint *names);

// --- Synchronisation
// --------------------------------------------------------------------------------

/// Why the host had to be brought up to date: an entry point's name, or a reason of reasons.def.
/// All pending images go to the host. Afterwards nothing is pending; shadows stay valid.
void synchronise(Context &context, const char *why);
/// The host is about to write to its draw framebuffer (a draw that is not ours): synchronise(),
/// then the framebuffer's images are the host's.
void hostDraws(Context &context, const char *why);
/// The same of what does not make the frame a mixed one (ContextState::hostTurns): a clear, or a
/// draw that will be ours.
void hostTakesTargets(Context &context, const char *why);
/// The host is about to run a list of its own, which may draw and do anything else.
void hostDrawsList(Context &context);
/// The host is about to do something unknown: synchronise(), then every image is the host's.
void hostDoesAnything(Context &context, const char *why);

// --- Frames and contexts
// ----------------------------------------------------------------------------

/// Viewport was called: the window may have another size since, and is asked at the next draw. A
/// rectangle that is new says that the application heard of one.
void drawableMayHaveChanged(Context &context, const swrast::Rect &viewport);

/// Before a draw looks at state: where a neighbour (neighbours.h) was current since, all that is
/// known of images and of the host's state is forgotten. False while one is current: the draw is
/// the host's, and so is every image.
[[nodiscard]] bool settle(Context &context);
/// Gives the memory back of what is not good any more. The context is current to no thread, and
/// does not become so meanwhile.
void forgetImages(Context &context);
/// The host's Flush or Finish, and around it what others can see of our pixels by then
/// (single-buffered windows, the application's memory of OSMesa, textures of several contexts).
void flush(Context &context, bool finish);
/// Before SwapBuffers and its kin: the window's pixels are shown by the window system (true: the
/// host has nothing to swap), or go to the host by the shortest way. The back buffer is kept.
[[nodiscard]] bool present(Context &context);
/// Before the context leaves the thread, or is destroyed while current.
void leave(Context &context);
/// After it became current: window sizes and contents may have changed.
void enter(Context &context);

/// Figures for --stats and for tests.
struct ResidencyStatistics {
  std::uint64_t copiesShared = 0;                   ///< feedback copies that moved no pixel
  std::uint64_t copiesInMemory = 0;                 ///< that copied from shadow to shadow
  std::uint64_t downloads = 0, downloadedBytes = 0; ///< host to shadow
  std::uint64_t uploads = 0, uploadedBytes = 0;     ///< shadow to host
  std::uint64_t shadowBytes = 0;                    ///< held now
};
[[nodiscard]] ResidencyStatistics residencyStatistics(const Context &context);

} // namespace arbiter::state::software
