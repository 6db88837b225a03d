#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "state/objects/display_list.h"
#include "state/objects/linked_stages.h"
#include "state/objects/program_object.h"
#include "state/objects/shader_table.h"
#include "state/objects/symbol_table.h"
#include "state/share/deleted_names.h"
#include "state/share/texture_formats.h"
#include "state/share/texture_ranges.h"
#include "state/share/texture_views.h"

namespace arbiter::state {

/// The state that contexts with common display lists share (AFP 3953-3974): the name space of
/// program objects, display lists that hold the layer's commands, and host objects that a destroyed
/// context left behind.
///
/// Gen, Delete, Bind, ProgramString and list calls take the lock; draws never do. The atomics
/// beside the maps tell without it that a map is empty.
class ShareGroup {
public:
  ShareGroup();
  ~ShareGroup();
  ShareGroup(const ShareGroup &) = delete;
  ShareGroup &operator=(const ShareGroup &) = delete;

  // --- Program objects: one name space for all targets (AFP 1364-1367) ---

  /// Returns the object of that name, or null. A name that Gen returned and that was never bound
  /// has no object.
  [[nodiscard]] std::shared_ptr<ProgramObject> find(GLuint name);
  /// Returns the object of that name and makes it if there is none. An existing object may have
  /// another target. An object that does not exist yet to the application is replaced by one for
  /// `target`.
  [[nodiscard]] std::shared_ptr<ProgramObject> findOrCreate(GLuint name, Target target,
                                                            std::size_t localParameters,
                                                            Existence existence = Existence::Now);
  /// Frees the name. The object lives on where it is bound. Returns null if there was none.
  std::shared_ptr<ProgramObject> remove(GLuint name);
  /// True if the name's object exists to the application.
  [[nodiscard]] bool contains(GLuint name);
  /// Returns an unused name that was not given before.
  [[nodiscard]] GLuint takeName();
  /// Returns the group's present objects that may have a text, including shaders of
  /// ATI_fragment_shader.
  [[nodiscard]] std::vector<std::shared_ptr<ProgramObject>> objects();
  void setCompiled(ProgramObject &object, std::shared_ptr<const CompiledProgram> compiled);
  [[nodiscard]] std::shared_ptr<const CompiledProgram> compiledOf(const ProgramObject &object);
  /// Returns object 0 of the target. It starts empty and so is invalid (AFP 4691).
  [[nodiscard]] const std::shared_ptr<ProgramObject> &defaultProgram(Target target) const {
    return m_defaults[std::size_t(target)];
  }
  void setDefaultLocals(Target target, std::size_t count);

  /// Shader objects of ATI_fragment_shader and of EXT_vertex_shader. Each table has its own lock.
  ShaderTable fragmentShaders{Target::AtiApi};
  ShaderTable vertexShaders{Target::VertexShader};
  VertexSymbolTable vertexSymbols;

  DeletedNames deletedNames;
  TextureViews textureViews;
  TextureFormats textureFormats;
  TextureRanges textureRanges;

  // --- Host objects to delete ---

  /// Host objects of a context that is gone. Any context of the group may delete them while it is
  /// current.
  struct Garbage {
    std::vector<GLuint> programs; ///< GLSL programs
    std::vector<GLuint> shaders;
    std::vector<GLuint> samplers;
    std::vector<GLuint> assembly; ///< program objects of the host's ARB path
  };
  void addGarbage(const Garbage &garbage);
  [[nodiscard]] bool hasGarbage() const { return m_hasGarbage.load(std::memory_order_acquire); }
  [[nodiscard]] Garbage takeGarbage();

  // --- The layer's programs and shaders on the host: IsProgram and the like must not know them ---

  void addHostProgram(GLuint name);
  void removeHostProgram(GLuint name);
  [[nodiscard]] bool ownsHostProgram(GLuint name);

  // --- Display lists that hold the layer's commands ---

  DisplayListTable lists;
  LinkedStages linkedStages;

  /// Set for good when a context of the group first uses a program target of the layer's. Until
  /// then lists are whole and the host's, and cost nothing.
  std::atomic<bool> programApiUsed{false};
  /// Set for good when ATI fragment shaders or register combiners are first enabled. From then on
  /// lists are cut at changes of the fixed-function state that such draws depend on.
  std::atomic<bool> shadersFollowFixedFunction{false};
  /// Set for good when a list first records the enable of a clip plane.
  std::atomic<bool> listsEnableClipPlanes{false};
  /// Set for good when TEXTURE_COMPARE_MODE is first set to another value than NONE.
  std::atomic<bool> compareModeUsed{false};
  /// Set for good when DEPTH_TEXTURE_MODE is first set to ALPHA. Draws then look for such textures.
  std::atomic<bool> alphaDepthsUsed{false};
  /// Set for good when an image first gets a format that may hold depths. Draws of register
  /// combiners then look for such images.
  std::atomic<bool> depthImagesUsed{false};
  /// A list that only the host keeps calls UseProgram; or calls other lists, which may push or pop
  /// attributes.
  std::atomic<bool> hostListsChangeProgram{false};
  std::atomic<bool> hostListsNest{false};
  /// A list on the host holds bitmaps, which a host may defer (kept_letters.h).
  std::atomic<bool> listsHoldLetters{false};
  std::atomic<int> contexts{0};
  /// The version of ARBITER_REPLACE's folder that the group's programs were compiled from.
  std::atomic<std::uint64_t> replacementsSeen{0};

private:
  std::mutex m_mutex;
  ProgramObjects m_objects;
  std::array<std::shared_ptr<ProgramObject>, kTargetCount> m_defaults;
  GLuint m_lastName = 0;
  std::unordered_set<GLuint> m_hostPrograms;
  Garbage m_garbage;
  std::atomic<bool> m_hasGarbage{false};
  std::atomic<int> m_hostProgramCount{0};
};

} // namespace arbiter::state
