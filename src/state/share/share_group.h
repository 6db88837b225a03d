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

/// What contexts that share display lists have in common (AFP 3953-3974): the name space of program
/// objects, display lists that hold our commands, and host objects that a dead context left behind.
///
/// The lock is taken by Gen, Delete, Bind and ProgramString and by list calls, never on the way of
/// a draw. The atomics beside the maps say "none" without it.
class ShareGroup {
public:
  ShareGroup();
  ~ShareGroup();
  ShareGroup(const ShareGroup &) = delete;
  ShareGroup &operator=(const ShareGroup &) = delete;

  // --- Program objects: one name space for all targets (AFP 1364-1367) ---

  /// The object of that name, or null. A name that Gen returned and that was never bound has no
  /// object.
  [[nodiscard]] std::shared_ptr<ProgramObject> find(GLuint name);
  /// The object of that name, made if there is none. Its target may not be `target`, unless it does
  /// not exist yet to the application: then it is made anew.
  [[nodiscard]] std::shared_ptr<ProgramObject> findOrCreate(GLuint name, Target target,
                                                            std::size_t localParameters,
                                                            Existence existence = Existence::Now);
  /// Frees the name; the object lives on where it is bound. Null if there was none.
  std::shared_ptr<ProgramObject> remove(GLuint name);
  /// True of an object that exists to the application.
  [[nodiscard]] bool contains(GLuint name);
  /// A name that is unused and was not given before.
  [[nodiscard]] GLuint takeName();
  /// Every object of the group that may have a text, shaders of ATI_fragment_shader among them, at
  /// this moment.
  [[nodiscard]] std::vector<std::shared_ptr<ProgramObject>> objects();
  void setCompiled(ProgramObject &object, std::shared_ptr<const CompiledProgram> compiled);
  [[nodiscard]] std::shared_ptr<const CompiledProgram> compiledOf(const ProgramObject &object);
  /// Object 0 of the target: starts empty, hence invalid (AFP 4691).
  [[nodiscard]] const std::shared_ptr<ProgramObject> &defaultProgram(Target target) const {
    return m_defaults[std::size_t(target)];
  }
  void setDefaultLocals(Target target, std::size_t count);

  /// Shader objects of ATI_fragment_shader and of EXT_vertex_shader, each under a lock of its own.
  ShaderTable fragmentShaders{Target::AtiApi};
  ShaderTable vertexShaders{Target::VertexShader};
  VertexSymbolTable vertexSymbols;

  DeletedNames deletedNames;
  TextureViews textureViews;
  TextureFormats textureFormats;
  TextureRanges textureRanges;

  // --- Host objects to delete ---

  /// Host GLSL programs of a context that is gone. Any context of the group may delete them, at a
  /// moment when it is current.
  struct Garbage {
    std::vector<GLuint> programs; ///< GLSL
    std::vector<GLuint> shaders;
    std::vector<GLuint> samplers;
    std::vector<GLuint> assembly; ///< program objects of the host's ARB path
  };
  void addGarbage(const Garbage &garbage);
  [[nodiscard]] bool hasGarbage() const { return m_hasGarbage.load(std::memory_order_acquire); }
  [[nodiscard]] Garbage takeGarbage();

  // --- Host programs and shaders of the layer's, so that IsProgram and its kin do not know them
  // ---

  void addHostProgram(GLuint name);
  void removeHostProgram(GLuint name);
  [[nodiscard]] bool ownsHostProgram(GLuint name);

  // --- Display lists that hold our commands ---

  DisplayListTable lists;
  LinkedStages linkedStages;

  /// Set for good by the first use of a program target of the layer's by any context of the group:
  /// until then lists are the host's own, whole, and cost nothing.
  std::atomic<bool> programApiUsed{false};
  /// Set for good by the first enable of ATI fragment shaders or register combiners: lists are cut
  /// where fixed-function state that their draws depend on changes.
  std::atomic<bool> shadersFollowFixedFunction{false};
  /// Set for good by the first enable of a clip plane that goes into a list.
  std::atomic<bool> listsEnableClipPlanes{false};
  /// Set for good by the first TEXTURE_COMPARE_MODE other than NONE.
  std::atomic<bool> compareModeUsed{false};
  /// DEPTH_TEXTURE_MODE was set to ALPHA: draws beside clip distances look for such images.
  std::atomic<bool> alphaDepthsUsed{false};
  /// Set for good by the first image that may hold depths: draws of register combiners look for
  /// such.
  std::atomic<bool> depthImagesUsed{false};
  /// A list kept by the host alone holds UseProgram, or calls others, which may push or pop
  /// attributes.
  std::atomic<bool> hostListsChangeProgram{false};
  std::atomic<bool> hostListsNest{false};
  /// A list of the host's holds bitmaps, which hosts may keep for later (kept_letters.h).
  std::atomic<bool> listsHoldLetters{false};
  std::atomic<int> contexts{0};
  /// The state of ARBITER_REPLACE's folder that the group's programs were compiled from.
  std::atomic<std::uint64_t> replacementsSeen{0};

private:
  std::mutex m_mutex;
  std::unordered_map<GLuint, std::shared_ptr<ProgramObject>> m_objects;
  std::array<std::shared_ptr<ProgramObject>, kTargetCount> m_defaults;
  GLuint m_lastName = 0;
  std::unordered_set<GLuint> m_hostPrograms;
  Garbage m_garbage;
  std::atomic<bool> m_hasGarbage{false};
  std::atomic<int> m_hostProgramCount{0};
};

} // namespace arbiter::state
