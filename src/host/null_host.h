#pragma once
#include <cstddef>

#include "host/host_table.h"

/// What a GL call does while no context of the layer's is current: it goes to the next definition
/// in the process (a libGL whose contexts do not pass through the layer, a library that an absolute
/// path named), or nowhere. Resolved at the first call of each, because that library may be loaded
/// late.
namespace arbiter::host {

/// One call on its way to the next definition. function() is null where there is none, and in a
/// call that came back to the layer: libGL's own stub may lead here.
class NullCall {
public:
  /// A null name: no call at all.
  /// \param index of a member of HostTable, or kFunctions and the number of a lazy function
  NullCall(const char *name, std::size_t index);
  ~NullCall();
  NullCall(const NullCall &) = delete;
  NullCall &operator=(const NullCall &) = delete;
  [[nodiscard]] void *function() const { return m_function; }

private:
  void *m_function = nullptr;
};

/// Constant-initialised: constructors of an application's own libraries run before the layer's and
/// may call GL.
extern const HostTable kNullHost;

} // namespace arbiter::host
