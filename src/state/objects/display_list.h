#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <GL/gl.h>

#include "state/objects/program_object.h"

namespace arbiter::host {
struct HostTable;
}

namespace arbiter::state {

class Geometry;

/// A command of the layer's in a display list. The host never sees it, so it cannot record it.
struct Command {
  enum class Kind : std::uint8_t {
    ProgramString, ///< target, format; bytes: a copy of the string, made when recorded
    BindProgram,   ///< target, name
    Env,           ///< target, name: first index; values
    Local,         ///< target, name: first index; values
    NamedString,   ///< as ProgramString, for `object`
    NamedLocal,    ///< as Local, for `object`
    Enable,        ///< target
    Disable,       ///< target
    UseProgram,    ///< name
    AttribPushed,  ///< name: mask; the host's segment before it has pushed
    PopAttrib,
    CallList,         ///< name
    CallLists,        ///< count, target: type; bytes: the names, ListBase is added when executed
    BeginConditional, ///< name: query; target: mode
    EndConditional,
    CopyTexture, ///< object: a CopyKind; target, format: internal, count: level,
                 ///< name: border; bytes: a CopyRegion
    // These are commands of NVIDIA's program API.
    LoadNv,           ///< target, name; count: the length; bytes: a copy of the text
    BindNv,           ///< target, name
    ExecuteNv,        ///< target, name; values: the input
    TrackMatrix,      ///< target, name: address; object: matrix; format: transform
    ParameterNv,      ///< target, name: first index; count; values, none if the count is an error
    NamedParameterNv, ///< name: of the program; bytes: of the parameter; values
    RequestResident,  ///< count; bytes: the names
    DefineMap,        ///< target, name and object: the orders; format: an error; values: the
                      ///< domain, the points
    PrepareEvaluation,
    EvalPoint,      ///< bytes: an EvaluatorPoint
    EvalMesh,       ///< target: mode; name: the dimension; bytes: four GLint
    SetFence,       ///< target: a FenceOf; name; format: the condition
    FinishFence,    ///< target, name
    Hint,           ///< target; name: the mode
    Combiners,      ///< bytes: some CombinerCommands, in a row
    TextureShaders, ///< bytes: some TextureShaderCommands, in a row
    Imaging,        ///< bytes: an ImagingCommand, and what belongs to it
    TextureRange,   ///< target; name: of a parameter, and format: its value, or 0; else count: the
                    ///< length, bytes: the pointer
    SpriteMode,     ///< target: POINT_SPRITE_R_MODE_NV's value
    PrimitiveMode,  ///< target: the mode of the next draws (host_draw/sprite_commands.h)
    CoordReplace,   ///< target: pname, count: the value of TexEnv of POINT_SPRITE
    State,          ///< bytes: StateCommands in a row (lists/known_state.h)
    ComponentImage, ///< bytes: a ComponentImage, then its components as floats
  };
  Kind kind;
  GLenum target = 0;
  GLuint name = 0;
  GLuint object = 0;
  GLenum format = 0;
  GLsizei count = 0;
  std::string bytes;
  std::vector<Vec4> values;
};

/// The effect of a run of commands on Begin/End: none, inside afterwards, or outside.
enum class Primitive : std::uint8_t { AsBefore, Open, Closed };

/// The effects of a called segment, as far as the rasterizer must know them. A list that was
/// compiled before the rasterizer was in use may do anything.
struct Effects {
  std::uint32_t dirty = ~0u; ///< groups of state (mirror/dirty_bits.h)
  bool pixels = true;        ///< draws, or reads or writes images
};

/// A list as a sequence of segments: host lists, primitives that the rasterizer may draw, and the
/// layer's commands.
struct DisplayList {
  struct Item {
    GLuint hostList = 0; ///< 0: a command or primitives
    std::unique_ptr<const Command> command;
    Primitive primitive = Primitive::AsBefore; ///< effect of the host list
    Effects effects;                           ///< of the host list; `dirty` also of a command
    std::shared_ptr<const Geometry> geometry;
  };
  std::vector<Item> items;
};

/// The display lists of a share group that hold the layer's commands, by name, and the names of
/// host lists for segments. Segments are named from the top of the name space. GenLists would give
/// names that an application which never calls it may soon use itself.
class DisplayListTable {
public:
  static constexpr GLuint kTop = 0xFFFFFF00u;

  [[nodiscard]] bool empty() const { return m_count.load(std::memory_order_acquire) == 0; }
  [[nodiscard]] std::shared_ptr<const DisplayList> find(GLuint name);
  /// Replaces the list of that name; null removes it. Deletes the old list's host segments, except
  /// `name` itself.
  void replace(const host::HostTable &host, GLuint name, std::shared_ptr<const DisplayList> list);
  /// Replaces an early list: a copy of a host list that holds only primitives and was compiled
  /// before the group's first program. The rasterizer draws it, if there is one. Null removes it.
  /// The total size is limited.
  void replaceEarly(const host::HostTable &host, GLuint name,
                    std::shared_ptr<const DisplayList> list);
  [[nodiscard]] std::shared_ptr<const DisplayList> findEarly(GLuint name);
  [[nodiscard]] bool hasEarly() const { return m_earlyCount.load(std::memory_order_acquire) != 0; }
  /// Forgets `count` early lists from `first` on, which are deleted or not worth their memory.
  void forgetEarly(const host::HostTable &host, GLuint first, GLuint count);
  /// Returns a free name for a segment.
  [[nodiscard]] GLuint takeSegmentName(const host::HostTable &host);
  [[nodiscard]] bool isSegment(GLuint name);
  /// True once a segment's name was taken. The host's GenLists then continues at the top.
  [[nodiscard]] bool hasSegments() const { return m_used.load(std::memory_order_acquire); }
  /// Does the work of GenLists: takes `count` free names in a row from the bottom and makes them
  /// empty lists on the host. Returns 0 if there are none. No list may be being compiled.
  [[nodiscard]] GLuint generate(const host::HostTable &host, GLsizei count);
  /// Notes that GenLists has made lists of these names, which are empty (OpenGL 2.1, 5.4) until
  /// they are compiled or deleted. Throws std::bad_alloc, after noting some of them.
  void noteEmpty(GLuint first, GLsizei count);
  /// Returns the names in [first, first + count) that have a list of the layer's.
  [[nodiscard]] std::vector<GLuint> namesIn(GLuint first, GLsizei count);
  /// Returns the segments whose names are in [first, first + count).
  [[nodiscard]] std::vector<GLuint> segmentsIn(GLuint first, GLsizei count);

private:
  void giveBack(const host::HostTable &host, GLuint segment);
  void giveBackSegments(const host::HostTable &host, const DisplayList &list, GLuint name);

  std::mutex m_mutex;
  std::unordered_map<GLuint, std::shared_ptr<const DisplayList>> m_lists;
  struct Early {
    std::shared_ptr<const DisplayList> list;
    std::size_t bytes = 0;
  };
  std::unordered_map<GLuint, Early> m_early;
  std::size_t m_earlyBytes = 0;
  std::unordered_set<GLuint> m_segments;
  std::vector<GLuint> m_free;
  GLuint m_next = kTop;
  GLuint m_nextGenerated = 1;
  std::atomic<bool> m_used{false};
  std::atomic<std::size_t> m_count{0}, m_earlyCount{0};
};

} // namespace arbiter::state
