#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "state/display_list.h"

namespace arbiter::state {

class Context;

/// The list between NewList and EndList. The host compiles into one host list after another; each
/// command of ours closes one and opens the next.
class ListCompiler {
public:
  /// Deeper calls are ignored, as GL_MAX_LIST_NESTING allows.
  static constexpr int kMaxDepth = 64;

  void begin(Context &context, GLuint name, GLenum mode);
  void end(Context &context);
  /// While a list is compiled: records `command`, and executes it too in COMPILE_AND_EXECUTE.
  void record(Context &context, Command command);
  /// Runs `function` outside the host's list, between two segments, recording nothing.
  template <typename Function> void outside(Context &context, Function &&function) {
    closeSegment(context);
    function();
    openSegment(context);
  }

  /// Ends a segment: when the list is called, what follows is a draw's look at the state again.
  void cut(Context &context) {
    outside(context, [] {});
  }

  [[nodiscard]] GLuint name() const { return m_name; } ///< LIST_INDEX
  /// The list's Begin or End.
  void notePrimitive(Primitive primitive) {
    m_endsFirst = m_endsFirst || (primitive == Primitive::Closed && !m_begun);
    m_begun = m_begun || primitive == Primitive::Open;
    m_primitive = primitive;
  }
  /// PushAttrib is the host's to compile. Our entry of the stack is made where the list is next
  /// cut, as nothing of ours has changed until there: a list that pops it before needs no cut.
  void notePush(GLbitfield mask) { m_pushes.push_back({mask, false}); }
  /// True if the pop must be a command of ours: its push has an entry of ours, or is in another
  /// list.
  [[nodiscard]] bool notePop();

private:
  struct Push {
    GLbitfield mask;
    bool noted; ///< as a command of ours
  };
  void closeSegment(Context &context);
  void openSegment(Context &context);
  void finishSegment();

  GLuint m_name = 0;
  GLuint m_segment = 0;                        ///< the host list being compiled
  Primitive m_primitive = Primitive::AsBefore; ///< of the segment
  bool m_begun = false;                        ///< the list has a Begin
  bool m_endsFirst = false;                    ///< its first End has no Begin in it
  std::vector<DisplayList::Item> m_items;
  std::vector<Push> m_pushes;
  std::uint16_t m_mode = 0; ///< while a segment is closed
};

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
