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
  /// The attribute stack as the list being compiled moves it; pops below zero count too.
  void notePush(bool cuts) { m_pushes.push_back(cuts); }
  /// True if the pop must be a command of ours: its push is one, or it is in no list of ours to
  /// see.
  [[nodiscard]] bool notePop(Context &context);

private:
  void closeSegment(Context &context);
  void openSegment(Context &context);

  GLuint m_name = 0;
  GLuint m_segment = 0; ///< the host list being compiled
  std::vector<DisplayList::Item> m_items;
  std::vector<bool> m_pushes;
  std::uint16_t m_mode = 0; ///< while a segment is closed
};

/// Runs one recorded command.
void execute(Context &context, const Command &command);
/// CallList: the list's segments in turn, or the host's list.
void callList(Context &context, GLuint name);
void callLists(Context &context, GLsizei count, GLenum type, const void *lists);
/// The size of CallLists' array; 0 if the arguments are not valid.
[[nodiscard]] std::size_t callListsBytes(GLsizei count, GLenum type);

} // namespace arbiter::state
