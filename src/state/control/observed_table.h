#pragma once
#include "host/host_table.h"

namespace arbiter::state::control {

class DrawObserver;

/// The host's functions, with those that draw, and that begin and end lists, redirected to an
/// observer.
struct ObservedTable : host::HostTable {
  ObservedTable(const host::HostTable &host, DrawObserver *to);
  DrawObserver *observer;
};

/// True if the table is an ObservedTable that still has an observer.
[[nodiscard]] bool isObservedTable(const host::HostTable &table);

} // namespace arbiter::state::control
