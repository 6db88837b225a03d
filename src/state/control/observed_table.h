#pragma once
#include "host/host_table.h"

namespace arbiter::state::remote {

class DrawObserver;

/// The host's functions, of which those that draw come to the observer, and those that begin and
/// end a list.
struct ObservedTable : host::HostTable {
  ObservedTable(const host::HostTable &host, DrawObserver *to);
  DrawObserver *observer;
};

/// The table is an ObservedTable whose draws still come to an observer.
[[nodiscard]] bool isObservedTable(const host::HostTable &table);

} // namespace arbiter::state::remote
