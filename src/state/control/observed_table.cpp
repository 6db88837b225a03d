#include "state/control/observed_table.h"

#include <algorithm>

#include "state/control/draw_observer.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

using host::HostTable;

/// Returns the observer of the thread's current context, whose table was called. While a list or a
/// primitive is recorded, the table is `trueHost`.
DrawObserver &observer() {
  const auto &context = static_cast<const RasterContext &>(*t_current);
  const HostTable *const table = isObservedTable(*context.host) ? context.host : context.trueHost;
  return *static_cast<const ObservedTable *>(table)->observer;
}

/// A string as a template parameter.
template <std::size_t kSize> struct Name {
  constexpr Name(const char (&text)[kSize]) { std::copy_n(text, kSize, value); }
  char value[kSize] = {};
};

/// Replaces a drawing function.
template <auto kFunction, Name kName> struct Draws;
template <typename... Parameters, void (*HostTable::*kFunction)(Parameters...), Name kName>
struct Draws<kFunction, kName> {
  static void call(Parameters... parameters) {
    observer().draw(kName.value, [=](const HostTable &host) { (host.*kFunction)(parameters...); });
  }
};

/// Replaces a function that calls display lists.
template <auto kFunction> struct Calls;
template <typename... Parameters, void (*HostTable::*kFunction)(Parameters...)>
struct Calls<kFunction> {
  static void call(Parameters... parameters) {
    observer().list([=](const HostTable &host) { (host.*kFunction)(parameters...); });
  }
};

void begin(GLenum mode) { observer().begin(mode); }
void end() { observer().end(); }
void newList(GLuint list, GLenum mode) { observer().newList(list, mode); }
void endList() { observer().endList(); }

void setFunctions(HostTable &table) {
#define ARBITER_DRAWS(name) table.name = Draws<&HostTable::name, "gl" #name>::call
  ARBITER_DRAWS(DrawArrays);
  ARBITER_DRAWS(DrawElements);
  ARBITER_DRAWS(DrawRangeElements);
  ARBITER_DRAWS(DrawElementsBaseVertex);
  ARBITER_DRAWS(DrawRangeElementsBaseVertex);
  ARBITER_DRAWS(DrawArraysInstanced);
  ARBITER_DRAWS(DrawElementsInstanced);
  ARBITER_DRAWS(DrawElementsInstancedBaseVertex);
  ARBITER_DRAWS(DrawArraysInstancedBaseInstance);
  ARBITER_DRAWS(DrawElementsInstancedBaseInstance);
  ARBITER_DRAWS(DrawElementsInstancedBaseVertexBaseInstance);
  ARBITER_DRAWS(DrawArraysIndirect);
  ARBITER_DRAWS(DrawElementsIndirect);
  ARBITER_DRAWS(MultiDrawArrays);
  ARBITER_DRAWS(MultiDrawElements);
  ARBITER_DRAWS(MultiDrawElementsBaseVertex);
  ARBITER_DRAWS(MultiDrawArraysIndirect);
  ARBITER_DRAWS(MultiDrawElementsIndirect);
  ARBITER_DRAWS(Rectd);
  ARBITER_DRAWS(Rectdv);
  ARBITER_DRAWS(Rectf);
  ARBITER_DRAWS(Rectfv);
  ARBITER_DRAWS(Recti);
  ARBITER_DRAWS(Rectiv);
  ARBITER_DRAWS(Rects);
  ARBITER_DRAWS(Rectsv);
  ARBITER_DRAWS(EvalMesh1);
  ARBITER_DRAWS(EvalMesh2);
#undef ARBITER_DRAWS
  table.CallList = Calls<&HostTable::CallList>::call;
  table.CallLists = Calls<&HostTable::CallLists>::call;
  table.Begin = begin;
  table.End = end;
  table.NewList = newList;
  table.EndList = endList;
}

} // namespace

ObservedTable::ObservedTable(const HostTable &host, DrawObserver *to)
    : HostTable(host), observer(to) {
  setFunctions(*this);
}

bool isObservedTable(const HostTable &table) { return table.Begin == begin; }

} // namespace arbiter::state::control
