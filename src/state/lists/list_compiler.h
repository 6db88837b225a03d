#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "state/lists/known_state.h"
#include "state/objects/list_recorder.h"
#include "state/primitives/geometry.h"
#include "state/primitives/recorder.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

/// Compiles the list between NewList and EndList. The host compiles one host list after another.
/// Each command of the layer's closes one, and the next is opened at the next call of the host.
/// Until then ContextHot::host is the recording table (raster_draw/immediate/replay.h).
///
/// Where the rasterizer may draw (raster_draw/context_state.h, keepsLists) the layer keeps
/// primitives itself. Host lists then hold the state between them, with notes of what each changes.
/// In COMPILE_AND_EXECUTE the host also executes its lists as it compiles them, and draws the
/// primitives outside of them. The rasterizer draws only when the list is called.
///
/// Before a share group's first program lists are whole and the host's. The layer keeps a copy of a
/// list that holds only primitives and attributes (`early`). The first other command drops it.
class ListCompiler final : public ListRecorder {
public:
  /// Deeper calls are ignored, as GL_MAX_LIST_NESTING allows.
  static constexpr int kMaxDepth = 64;

  void begin(RasterContext &context, GLuint name, GLenum mode);
  void end(RasterContext &context);
  void record(CoreContext &lower, Command command) override;

  /// True if a command that only sets state may be kept: between kept primitives, in a list that is
  /// not executed.
  [[nodiscard]] bool keepsState() const {
    return m_keeps && m_mode == GL_COMPILE && !m_recording && !m_open && m_segment == 0;
  }
  /// Keeps the command, unless the list has set the same. Requires: keepsState().
  void recordState(RasterContext &context, const StateCommand &command, std::uint32_t dirty);

  // --- Kept primitives ---

  [[nodiscard]] bool beginPrimitive(CoreContext &lower, GLenum mode) override;
  void endPrimitive(CoreContext &lower, bool fromArrays = false) override;
  [[nodiscard]] bool recordsPrimitive() const override { return m_recording; }
  [[nodiscard]] ImmediateRecorder &recorder() override { return m_recorder; }
  void giveHost(CoreContext &lower) override {
    RasterContext &context = rasterStep(lower);
    if (m_early)
      return leaveEarly(context);
    leavePrimitive(context);
    if (m_segment == 0)
      openSegment(context);
  }
  /// Ends the recording before a command that is no part of the primitive. The primitive so far
  /// becomes an item that leaves Begin/End open. In COMPILE_AND_EXECUTE the host gets the primitive
  /// from here on, as calls between two host lists would be inside Begin/End.
  void leavePrimitive(RasterContext &context) {
    if (m_recording)
      interruptPrimitive(context);
  }
  /// Gives the recorded primitive to the host, before an erroneous Begin inside of it, so that the
  /// host judges it when the list is called. It compiles the primitive from its first Begin: hosts
  /// keep what is between Begin and End as one draw, so a host list with just a Begin would not do.
  void givePrimitive(RasterContext &context);
  void notePixels() override { m_pixels = true; }
  [[nodiscard]] bool keeps() const override { return m_keeps || m_early; }
  [[nodiscard]] bool isEarly() const override { return m_early; }
  [[nodiscard]] bool executes() const override {
    return m_keeps && m_mode == GL_COMPILE_AND_EXECUTE;
  }
  [[nodiscard]] bool beginExecuted(CoreContext &lower, GLenum mode) override;
  void endExecuted(CoreContext &lower) override;
  [[nodiscard]] bool hasRoom(GLsizei count) const override;
  /// Makes the list the host's alone from here on.
  void leaveEarly(RasterContext &context);
  [[nodiscard]] Arrays &arrays() override { return m_arrays; }
  [[nodiscard]] bool takeArraysDirty(CoreContext &lower) override;

  [[nodiscard]] GLuint name() const { return m_name; } ///< for LIST_INDEX
  [[nodiscard]] bool changesKind(bool points) override {
    const Kind kind = points ? Kind::Points : Kind::Others;
    return std::exchange(m_kind, kind) != kind;
  }
  /// Notes a Begin or End of the list that the host compiles.
  void notePrimitive(Primitive primitive) {
    m_endsFirst = m_endsFirst || (primitive == Primitive::Closed && !m_begun);
    m_begun = m_begun || primitive == Primitive::Open;
    m_open = primitive == Primitive::Open;
    m_primitive = primitive;
  }
  /// Notes a PushAttrib that the host compiles. The layer's stack entry is made where the list is
  /// next cut, as nothing of the layer's changes before. A list that pops before that needs no cut.
  void notePush(GLbitfield mask) { m_pushes.push_back({mask, false}); }
  /// True if the pop must be a command of the layer's: its push has an entry of the layer's or is
  /// in another list.
  [[nodiscard]] bool notePop();

private:
  struct Push {
    GLbitfield mask;
    bool noted; ///< as a command of the layer's
  };
  // --- Early lists, whose commands the host compiles too (early_list.cpp) ---
  void beginEarly(RasterContext &context);
  /// Makes an item of the attributes that were set outside primitives so far.
  void takeOutsideAttributes(RasterContext &context);
  void endEarlyPrimitive(RasterContext &context, bool fromArrays);
  /// Starts to record attributes outside primitives.
  void recordOutsideAttributes(RasterContext &context);
  /// Makes a primitive of too many vertices end the early list.
  void limitPrimitive(RasterContext &context);
  static bool leaveFull(void *owner, const float position[4]);
  [[nodiscard]] std::shared_ptr<DisplayList> endEarly(RasterContext &context);

  // --- Segments: host lists of consecutive commands that the host compiles ---
  void openSegment(RasterContext &context);
  void validateSegment(RasterContext &context);
  /// Ends the host's compilation, so that commands of the layer may call the host.
  void closeSegment(RasterContext &context);
  /// True if the last item is the last thing in the list.
  [[nodiscard]] bool follows() const { return keepsState() && !m_geometry && !m_items.empty(); }
  void interrupt(CoreContext &lower) override {
    m_known.forget();
    closeSegment(rasterStep(lower));
  }
  void resume(CoreContext &lower) override;
  void finishSegment();

  // --- A primitive between Begin and End, which the layer records ---
  void stopPrimitive(RasterContext &context);
  void executePrimitive(RasterContext &context);
  /// Makes an item of the primitive so far, which leaves Begin/End open.
  void interruptPrimitive(RasterContext &context);
  void keepPrimitive(bool fromArrays);
  /// Makes an item of the complete primitives that are kept.
  void finishGeometry();

  void setMode(RasterContext &context, std::uint16_t mode);
  void define(RasterContext &context, std::shared_ptr<const DisplayList> list);

  GLuint m_name = 0;
  GLuint m_segment = 0; ///< the host list being compiled; 0: none
  bool m_keeps = false;
  bool m_early = false;
  std::uint32_t m_earlyVertices = 0;
  bool m_recording = false;                    ///< a primitive is being recorded
  Primitive m_primitive = Primitive::AsBefore; ///< effect of the segment
  bool m_open = false;                         ///< a primitive is open and not recorded
  bool m_begun = false;                        ///< the host's part of the list has a Begin
  bool m_endsFirst = false;                    ///< the list's first End has no Begin before it
  bool m_pixels = false;                       ///< Effects::pixels of the segment
  std::uint32_t m_dirty = 0;                   ///< ContextHot::dirty without the segment's part
  bool m_arraysDirty = true;                   ///< arrays changed since the last draw, or the list
                                               ///< has no draw yet
  std::vector<DisplayList::Item> m_items;
  std::unique_ptr<Geometry> m_geometry; ///< complete primitives after the last item
  ImmediateRecorder m_recorder;
  ImmediateRecorder m_outside; ///< attributes outside primitives in an early list
  Arrays m_arrays{nullptr, nullptr};
  std::vector<Push> m_pushes;
  KnownState m_known;
  enum class Kind : std::uint8_t { None, Points, Others };
  Kind m_kind = Kind::None;
  std::uint16_t m_mode = 0;
};

/// Returns the list compiler of a context that is no null context.
[[nodiscard]] inline ListCompiler &listCompiler(RasterContext &context) {
  return static_cast<ListCompiler &>(*context.list);
}

/// Executes one recorded command.
void execute(RasterContext &context, const Command &command);
/// Executes CallList: the list's segments in order, or the host's list.
void callList(RasterContext &context, GLuint name);
void callLists(RasterContext &context, GLsizei count, GLenum type, const void *lists);
/// Executes CallList between Begin and End in COMPILE_AND_EXECUTE, where the host's list cannot be
/// cut. The host gets the segments of `name`.
void callListIntoHost(RasterContext &context, GLuint name);
/// Returns the size of CallLists' array; 0 if the arguments are invalid.
[[nodiscard]] std::size_t callListsBytes(GLsizei count, GLenum type);

} // namespace arbiter::state
