#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "state/core/context.h"
#include "state/lists/known_state.h"
#include "state/objects/list_recorder.h"
#include "state/primitives/geometry.h"
#include "state/primitives/recorder.h"

namespace arbiter::state {

/// The list between NewList and EndList. The host compiles into one host list after another; each
/// command of the layer's closes one, and the next is opened when the host is called again: until
/// then ContextHot::host is the table that stands in for it (raster_draw/immediate/replay.h).
///
/// Where the rasterizer may draw (raster_draw/context_state.h, keepsLists) primitives are kept from
/// the host: its lists hold the state between them, and what each changes is noted. Of a list that
/// is executed as it is compiled the host executes its parts as it compiles them, and draws the
/// primitives outside of its lists; nothing is the rasterizer's until the list is called again.
///
/// Before a share group makes its first program lists are the host's, whole. One that holds nothing
/// but primitives and attributes is kept as well (`early`): the first other command makes it the
/// host's alone.
class ListCompiler final : public ListRecorder {
public:
  /// Deeper calls are ignored, as GL_MAX_LIST_NESTING allows.
  static constexpr int kMaxDepth = 64;

  void begin(Context &context, GLuint name, GLenum mode);
  void end(Context &context);
  void record(Context &context, Command command) override;

  /// A command that only sets state may be kept: between primitives that are, and not of a list
  /// that is executed too.
  [[nodiscard]] bool keepsState() const {
    return m_keeps && m_mode == GL_COMPILE && !m_recording && !m_open && m_segment == 0;
  }
  /// Keeps it, or leaves it out where the list has set the same. Requires: keepsState().
  void recordState(Context &context, const StateCommand &command, std::uint32_t dirty);

  // --- Primitives that are kept ---

  [[nodiscard]] bool beginPrimitive(Context &context, GLenum mode) override;
  void endPrimitive(Context &context, bool fromArrays = false) override;
  [[nodiscard]] bool recordsPrimitive() const override { return m_recording; }
  [[nodiscard]] software::ImmediateRecorder &recorder() override { return m_recorder; }
  void giveHost(Context &context) override {
    if (m_early)
      return leaveEarly(context);
    leavePrimitive(context);
    if (m_segment == 0)
      openSegment(context);
  }
  /// Before a command that is no part of a primitive that is recorded: it is an item up to here,
  /// which leaves Begin/End open, and its rest is what comes. Of a list that is executed too the
  /// primitive is the host's from here on, as what would be between two of its lists is inside
  /// Begin/End.
  void leavePrimitive(Context &context) {
    if (m_recording)
      interruptPrimitive(context);
  }
  /// Before a Begin inside of the primitive that is recorded, a mistake that the host is to judge
  /// when the list is called: it compiles the primitive from its Begin on. A host list of a Begin
  /// alone would not do: hosts keep what is between Begin and End as a draw.
  void givePrimitive(Context &context);
  void notePixels() override { m_pixels = true; }
  [[nodiscard]] bool keeps() const override { return m_keeps || m_early; }
  [[nodiscard]] bool isEarly() const override { return m_early; }
  [[nodiscard]] bool executes() const override {
    return m_keeps && m_mode == GL_COMPILE_AND_EXECUTE;
  }
  [[nodiscard]] bool beginExecuted(Context &context, GLenum mode) override;
  void endExecuted(Context &context) override;
  [[nodiscard]] bool hasRoom(GLsizei count) const override;
  /// The list is the host's alone from here on.
  void leaveEarly(Context &context);
  [[nodiscard]] Arrays &arrays() override { return m_arrays; }
  [[nodiscard]] bool takeArraysDirty(Context &context) override;

  [[nodiscard]] GLuint name() const { return m_name; } ///< LIST_INDEX
  [[nodiscard]] bool changesKind(bool points) override {
    const Kind kind = points ? Kind::Points : Kind::Others;
    return std::exchange(m_kind, kind) != kind;
  }
  /// The list's Begin or End, of the host's.
  void notePrimitive(Primitive primitive) {
    m_endsFirst = m_endsFirst || (primitive == Primitive::Closed && !m_begun);
    m_begun = m_begun || primitive == Primitive::Open;
    m_open = primitive == Primitive::Open;
    m_primitive = primitive;
  }
  /// PushAttrib is the host's to compile. Our entry of the stack is made where the list is next
  /// cut, as nothing of the layer's has changed until there: a list that pops it before needs no
  /// cut.
  void notePush(GLbitfield mask) { m_pushes.push_back({mask, false}); }
  /// True if the pop must be a command of the layer's: its push has an entry of the layer's, or is
  /// in another list.
  [[nodiscard]] bool notePop();

private:
  struct Push {
    GLbitfield mask;
    bool noted; ///< as a command of the layer's
  };
  // Of an early list, whose commands the host compiles too (early_list.cpp).
  void beginEarly(Context &context);
  /// Makes an item of the attributes set outside of primitives so far.
  void takeOutsideAttributes(Context &context);
  void endEarlyPrimitive(Context &context, bool fromArrays);
  /// From here on attributes outside of primitives are recorded.
  void recordOutsideAttributes(Context &context);
  /// A primitive of too many vertices makes the list the host's alone.
  void limitPrimitive(Context &context);
  static bool leaveFull(void *owner, const float position[4]);
  [[nodiscard]] std::shared_ptr<DisplayList> endEarly(Context &context);

  // A segment is a host list of consecutive commands that the host compiles.
  void openSegment(Context &context);
  void validateSegment(Context &context);
  /// Ends the host's compilation, so that commands of the layer may run on the host.
  void closeSegment(Context &context);
  /// The last item is what the list has last.
  [[nodiscard]] bool follows() const { return keepsState() && !m_geometry && !m_items.empty(); }
  void interrupt(Context &context) override {
    m_known.forget();
    closeSegment(context);
  }
  void resume(Context &context) override;
  void finishSegment();

  // A primitive between Begin and End, which is recorded by the layer.
  void stopPrimitive(Context &context);
  void executePrimitive(Context &context);
  /// Keeps the primitive's vertices so far as an item that leaves Begin/End open.
  void interruptPrimitive(Context &context);
  void keepPrimitive(bool fromArrays);
  /// Makes an item of the whole primitives that are kept.
  void finishGeometry();

  void setMode(Context &context, std::uint16_t mode);
  void define(Context &context, std::shared_ptr<const DisplayList> list);

  GLuint m_name = 0;
  GLuint m_segment = 0; ///< the host list being compiled; 0: none
  bool m_keeps = false;
  bool m_early = false;
  std::uint32_t m_earlyVertices = 0;
  bool m_recording = false;                    ///< a primitive, since its Begin
  Primitive m_primitive = Primitive::AsBefore; ///< of the segment
  bool m_open = false;                         ///< a primitive is, and not recorded
  bool m_begun = false;                        ///< the host's part of the list has a Begin
  bool m_endsFirst = false;                    ///< its first End has no Begin in it
  bool m_pixels = false;                       ///< Effects of the segment
  std::uint32_t m_dirty = 0;                   ///< ContextHot::dirty without the segment's part
  bool m_arraysDirty = true;                   ///< takeArraysDirty() of the list's first draw
  std::vector<DisplayList::Item> m_items;
  std::unique_ptr<software::Geometry> m_geometry; ///< whole primitives, after the last item
  software::ImmediateRecorder m_recorder;
  software::ImmediateRecorder m_outside; ///< attributes outside of primitives, of an early list
  Arrays m_arrays{nullptr, nullptr};
  std::vector<Push> m_pushes;
  KnownState m_known;
  enum class Kind : std::uint8_t { None, Points, Others };
  Kind m_kind = Kind::None;
  std::uint16_t m_mode = 0;
};

/// Returns the list compiler of a context that is no null context.
[[nodiscard]] inline ListCompiler &listCompiler(Context &context) {
  return static_cast<ListCompiler &>(*context.list);
}

/// Runs one recorded command.
void execute(Context &context, const Command &command);
/// CallList: the list's segments in turn, or the host's list.
void callList(Context &context, GLuint name);
void callLists(Context &context, GLsizei count, GLenum type, const void *lists);
/// CallList between Begin and End while a list is compiled and executed, where the host's list
/// cannot be cut: the host gets the segments of `name`.
void callListIntoHost(Context &context, GLuint name);
/// The size of CallLists' array; 0 if the arguments are not valid.
[[nodiscard]] std::size_t callListsBytes(GLsizei count, GLenum type);

} // namespace arbiter::state
