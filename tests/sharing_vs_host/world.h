#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "../rasterizer_vs_host/surface.h"
#include "platform.h"
#include "workers.h"

/// Two to four contexts in one or two share groups, on three threads, and the objects that a random
/// sequence of commands uses.
///
/// The order is one that GL defines (OpenGL 4.6, chapter 5): contexts take turns, and one's
/// commands are complete before the next one's begin (Finish, or a fence that is waited for). An
/// object that another context changed is bound or attached again before it is used. Command number
/// i depends only on the seed and on i, so that a sequence keeps its meaning when commands are left
/// out.
namespace sharing {

using software::Random;

inline constexpr int kContexts = 4, kGroups = 2;
inline constexpr int kTextures = 4, kRenderbuffers = 2, kBuffers = 3, kFramebuffers = 2;
inline constexpr int kFragmentPrograms = 4, kVertexPrograms = 2, kLists = 2;

/// The common part of all objects: a version, by which other contexts know that they must bind it
/// again.
struct Object {
  GLuint name = 0;
  std::uint64_t version = 0; ///< increases with new storage or a new name
};
struct Texture : Object {
  int width = 0, height = 0;
  GLenum internal = GL_RGBA8;
};
struct Renderbuffer : Object {
  int width = 0, height = 0;
  GLenum internal = GL_RGBA8;
  /// Returns the attachment point.
  [[nodiscard]] GLenum point() const {
    return internal == GL_RGBA8              ? GL_COLOR_ATTACHMENT0
           : internal == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT
                                             : GL_DEPTH_ATTACHMENT;
  }
};
/// A buffer of quads with four vertices each, or of their indices.
struct Buffer : Object {
  int quads = 0;
  bool mapped = false;
  void *pointer = nullptr; ///< while mapped
};
struct Program : Object {
  int text = 0;
  unsigned users = 0; ///< the contexts that bound it, one bit each
};
struct Group {
  bool made = false;
  std::array<Texture, kTextures> textures;
  std::array<Renderbuffer, kRenderbuffers> colors, depths;
  std::array<Buffer, kBuffers> buffers;
  std::array<Program, kFragmentPrograms> fragments;
  std::array<Program, kVertexPrograms> vertices;
  std::array<GLuint, kLists> lists{};
};

struct Attachment {
  bool isTexture = false;
  int index = -1;            ///< of the group's textures or renderbuffers; -1: none
  std::uint64_t version = 0; ///< of the object when it was attached
  bool orphan = false;       ///< the object was deleted: the attachment has no name any more
  int width = 0, height = 0; ///< of the attachment
};
struct Framebuffer {
  GLuint name = 0;
  Attachment color, depth;
};
/// The group's last texture stays bound to unit 1, even if its name is deleted.
inline constexpr int kKept = kTextures - 1;
struct Kept {
  bool bound = false, orphan = false; ///< another context deleted it
  int width = 0, height = 0;
};
struct Context {
  void *handle = nullptr;
  int group = 0, drawable = 0;
  int thread = -1; ///< the thread that it is current on; -1: none
  /// Loads objects and never draws, so that the layer's rasterizer does not serve it
  bool loads = false;
  bool made = false;
  std::array<Framebuffer, kFramebuffers> framebuffers;
  GLuint scratch = 0; ///< a framebuffer for clearing new objects
  int bound = -1;     ///< index of `framebuffers`; -1: the drawable
  Kept kept;
};
struct Drawable {
  void *handle = nullptr;
  Size size;
  bool undefined = true; ///< whether the contents are undefined
};

class World {
public:
  World(Platform &platform, Workers &workers) : m_platform(platform), m_workers(workers) {}
  void open(Random &random);
  void close();

  [[nodiscard]] int contexts() const { return m_count; }
  [[nodiscard]] Context &context() { return m_contexts[std::size_t(m_current)]; }
  [[nodiscard]] const Context &context(int i) const { return m_contexts[std::size_t(i)]; }
  [[nodiscard]] Group &group() { return m_groups[std::size_t(context().group)]; }
  [[nodiscard]] Texture &texture(int i) { return group().textures[std::size_t(i)]; }
  /// Returns the size of the bound target; false if ready() is, or if the context only loads.
  [[nodiscard]] bool readyToDraw(int &width, int &height) {
    return !context().loads && ready(width, height);
  }
  [[nodiscard]] Platform &platform() { return m_platform; }
  [[nodiscard]] Drawable &drawable() { return m_drawables[std::size_t(context().drawable)]; }
  /// Runs the work on the current context's thread.
  template <typename Work> void here(const Work &work) { m_workers.run(context().thread, work); }

  // --- contexts.cpp; called on the main thread ---
  enum class Ending { Finish, Fence, Flush };
  /// Gives the turn to another context: the commands so far are completed by `ending`.
  void handOn(int context, int thread, int drawable, Ending ending, bool release);
  /// Destroys a context, current or not, and makes another in its place.
  void remake(int context);

  // --- Commands of GL; called on the context's thread ---
  /// Attaches again what another context changed, and returns the size of the bound target; false
  /// if nothing may be drawn or read there.
  [[nodiscard]] bool ready(int &width, int &height);
  void bindFramebuffer(int which);
  void attach(Framebuffer &framebuffer, bool depth, bool isTexture, int index);
  /// True if the bound target has the texture: sampling it while drawing would be undefined.
  [[nodiscard]] bool isAttached(int texture);
  void define(Texture &texture, int width, int height, GLenum internal, Random &random);
  void defineRenderbuffer(Renderbuffer &renderbuffer, GLenum internal, int width, int height);
  void defineBuffer(int index, int quads, Random &random);
  void load(Program &program, GLenum target, int text, Random &random);
  /// Binds the program again, as is needed after another context's change.
  void bind(GLenum target, Program &program);
  [[nodiscard]] bool isUsedElsewhere(const Program &program) const {
    return (program.users & ~(1u << m_current)) != 0;
  }
  /// Marks the object's attachments in all framebuffers of the group as nameless.
  void orphan(bool isTexture, const Object *object);
  void clearAll();
  void recordAll(const std::string &what);

private:
  void makeObjects();
  void makeContextObjects();
  void makeCurrentHere(int context);
  [[nodiscard]] Object *objectOf(const Attachment &attachment, bool depth);
  [[nodiscard]] Size sizeOf(const Attachment &attachment, bool depth);

  Platform &m_platform;
  Workers &m_workers;
  int m_count = 0, m_current = 0;
  std::uint64_t m_version = 0;
  std::array<Context, kContexts> m_contexts;
  std::array<Group, kGroups> m_groups;
  std::array<Drawable, kContexts> m_drawables;
};

/// Binds a texture to unit 0 and leaves it active.
inline void bindTexture(GLuint name) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, name);
}

/// A vertex of the buffers.
struct Vertex {
  float x, y, z, u, v;
  unsigned char rgba[4];
};
[[nodiscard]] std::vector<Vertex> randomQuads(int quads, Random &random);

/// The counts of the programs' texts, which are exact in any arithmetic. Those that sample come
/// first.
inline constexpr int kFragmentTexts = 6, kSamplingTexts = 3, kVertexTexts = 3;
[[nodiscard]] const char *fragmentText(int text);
[[nodiscard]] const char *vertexText(int text);

/// A kind of command; those on contexts are executed on the main thread.
struct Command {
  const char *name;
  int weight;
  void (*run)(World &world, Random &random, const std::string &what);
  bool ofContexts = false;
};
extern const std::vector<Command> kContextCommands, kTextureCommands, kDrawCommands,
    kBufferCommands, kProgramCommands;

/// Writes what was read to standard output, as a record, or as a line with its hash.
void record(const std::string &what, const std::vector<unsigned char> &bytes);
/// Writes full records instead of hashes.
extern bool g_wholeRecords;

} // namespace sharing
