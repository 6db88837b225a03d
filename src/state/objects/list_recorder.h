#pragma once
#include <memory>

#include <GL/gl.h>

#include "state/objects/display_list.h"

namespace arbiter::state {

struct CoreContext;

class ImmediateRecorder;
class ListArrays;

/// The display list between NewList and EndList, as the rooms below the list compiler see it
/// (lists/list_compiler.h).
class ListRecorder {
public:
  ListRecorder() = default;
  virtual ~ListRecorder() = default;
  ListRecorder(const ListRecorder &) = delete;
  ListRecorder &operator=(const ListRecorder &) = delete;

  /// Records `command`, and executes it too in COMPILE_AND_EXECUTE.
  virtual void record(CoreContext &context, Command command) = 0;
  /// Runs `function` outside the host's list, between two segments, recording nothing.
  template <typename Function> void outside(CoreContext &context, Function &&function) {
    interrupt(context);
    function();
    resume(context);
  }
  /// Ends a segment: when the list is called, the next draw looks at the state again.
  void cut(CoreContext &context) {
    outside(context, [] {});
  }

  /// Called at Begin. Returns true if the primitive is recorded; endPrimitive() then ends it,
  /// unless it was interrupted before (recordsPrimitive()).
  [[nodiscard]] virtual bool beginPrimitive(CoreContext &context, GLenum mode) = 0;
  /// \param fromArrays the draw leaves current values undefined (OpenGL 2.1, 2.8)
  virtual void endPrimitive(CoreContext &context, bool fromArrays = false) = 0;
  [[nodiscard]] virtual bool recordsPrimitive() const = 0;
  [[nodiscard]] virtual ImmediateRecorder &recorder() = 0;
  /// Makes the host compile the commands that follow. An open segment is the host's already.
  virtual void giveHost(CoreContext &context) = 0;
  /// Notes that the next command of the host draws, or reads or writes images.
  virtual void notePixels() = 0;
  /// Notes whether the draws that follow are of points. Returns true if the draws before were not,
  /// or the other way round.
  [[nodiscard]] virtual bool changesKind(bool points) = 0;

  /// True if the layer keeps primitives.
  [[nodiscard]] virtual bool keeps() const = 0;
  /// True if the host compiles the kept primitives too.
  [[nodiscard]] virtual bool isEarly() const = 0;
  /// True if kept primitives are executed too.
  [[nodiscard]] virtual bool executes() const = 0;
  /// Prepares the host to draw a kept primitive outside of its lists. Requires: executes(), and no
  /// segment is open.
  /// \return false if a program is not valid; endExecuted() follows all the same
  [[nodiscard]] virtual bool beginExecuted(CoreContext &context, GLenum mode) = 0;
  virtual void endExecuted(CoreContext &context) = 0;
  /// True if a draw of `count` vertices may be kept.
  [[nodiscard]] virtual bool hasRoom(GLsizei count) const = 0;
  using Arrays = std::unique_ptr<ListArrays, void (*)(ListArrays *)>;
  /// The reader of vertex arrays; null until it is first needed. Its maker
  /// (raster_draw/immediate/list_arrays.cpp) gives the deleter.
  [[nodiscard]] virtual Arrays &arrays() = 0;
  /// Returns true if vertex arrays may have changed since the last call, or since the list began.
  [[nodiscard]] virtual bool takeArraysDirty(CoreContext &context) = 0;

private:
  /// Ends the host's compilation for a while, and goes on with it.
  virtual void interrupt(CoreContext &context) = 0;
  virtual void resume(CoreContext &context) = 0;
};

} // namespace arbiter::state
