#pragma once
#include <array>

#include "surface.h"

/// The objects that a random sequence of commands uses. Command number i depends only on the seed
/// and on i, so that a sequence keeps its meaning when commands are left out. State that commands
/// need (sizes, attachments) is tracked here while they are executed.
namespace software {

inline constexpr int kTextures = 5; ///< the last is a rectangle, and never attached
inline constexpr int kRectangle = 4;
inline constexpr int kPrograms = 9;
inline constexpr int kLists = 3;
inline constexpr int kWindow = 64; ///< width and height of the window and of renderbuffers
inline constexpr int kPbufferWidth = 48, kPbufferHeight = 40;

struct Texture {
  GLuint name = 0;
  std::array<int, 2> width{}, height{}; ///< of levels 0 and 1; 0: not defined
  GLenum internal = 0;                  ///< of both levels
};

/// The objects that contexts share.
struct Group {
  bool made = false;
  std::array<Texture, kTextures> textures;
  GLuint lastName = 0; ///< the highest texture name so far
  std::array<GLuint, kPrograms> programs{};
};

struct Framebuffer {
  GLuint name = 0, color = 0, depthStencil = 0; ///< the renderbuffers
  int texture = -1;                             ///< attached instead of `color`; -1: none
  int level = 0;
  bool orphan = false; ///< unusable, as its texture is deleted or has new storage
};

struct Context {
  GLXContext handle = nullptr;
  int group = 0;
  bool made = false;
  std::array<Framebuffer, 2> framebuffers;
  int bound = -1; ///< index of `framebuffers`; -1: the window's
  std::array<bool, kLists> lists{};
  GLuint firstList = 0, vertexBuffer = 0, indexBuffer = 0, query = 0;
};

class World {
public:
  [[nodiscard]] bool open();
  [[nodiscard]] Context &context() { return m_contexts[std::size_t(m_current)]; }
  [[nodiscard]] Group &group() { return m_groups[std::size_t(context().group)]; }
  [[nodiscard]] Texture &texture(int i) { return group().textures[std::size_t(i)]; }
  [[nodiscard]] static GLenum targetOf(int texture);
  /// Makes context `context` current on the window (0) or the pbuffer (1).
  void switchTo(int context, int drawable);
  void bindFramebuffer(int which);
  /// Returns the size of the bound framebuffer; false if nothing may be drawn or read there.
  [[nodiscard]] bool size(int &width, int &height);
  /// Sets viewport and projection so that a unit is a pixel of the bound framebuffer.
  void fit();
  /// True if the bound framebuffer has the texture: reading it while drawing would be undefined.
  [[nodiscard]] bool attached(int texture);
  /// Defines a level from `random`.
  void define(int texture, int level, int width, int height, GLenum internal, Random &random);
  void redefine(int texture, Random &random);
  /// Defines level 1 with its mipmap size, if there can be one. It has level 0's sized format: Mesa
  /// 22.3.6 loses the texels of a level of another format when it draws with the texture.
  [[nodiscard]] bool defineLevel1(int texture, Random &random);
  /// Forgets level 1 after level 0 was redefined with another size. Mesa 22.3.6 then handles level
  /// 1 wrong until it draws with the texture.
  void dropLevel1(int texture);
  void attach(int framebuffer, int texture, int level);
  /// Marks framebuffers with the texture as unusable until something is attached to them again.
  void orphan(int texture);
  void deleteTexture(int texture, Random &random);
  /// Clears all of the bound framebuffer, whatever the masks.
  void clearAll();
  /// Shows the window, records its visible content, clears the back buffer.
  void swap(const std::string &what);
  /// Reads everything that can be read.
  void recordAll();

private:
  /// Returns a new texture name. Hosts decide whether names of deleted textures are reused, which
  /// PopAttrib would reveal, as it finds saved bindings by name.
  [[nodiscard]] GLuint newTexture();
  void makeContextObjects();
  void makeGroupObjects();

  Screen m_screen;
  std::array<GLXDrawable, 2> m_drawables{};
  std::array<Context, 3> m_contexts;
  std::array<Group, 2> m_groups;
  int m_current = 0, m_drawable = 0;
};

/// A kind of command.
struct Command {
  const char *name;
  int weight;
  void (*run)(World &world, Random &random, const std::string &what);
};
extern const std::vector<Command> kDrawCommands, kPixelCommands, kStateCommands, kListCommands;

/// Makes a draw that may be compiled into a list: it samples no texture that can be attached.
void drawForList(World &world, Random &random);

} // namespace software
