#pragma once
#include <cstddef>

#include "host/host_table.h"

/// Dispatch of GL calls while the layer has no current context. A call goes to the next definition
/// in the process: a libGL whose contexts do not pass through the layer, or a library loaded by an
/// absolute path. If there is none, the call does nothing. Each function is resolved at its first
/// call, because that library may be loaded late.
namespace arbiter::host {

/// One call to the next definition. function() returns null if there is none, or if the call came
/// back to the layer: libGL's own stub may lead here.
class NullCall {
public:
  /// Takes a null name for no call at all.
  /// \param index of a member of HostTable, or kFunctions plus the number of a lazy function
  NullCall(const char *name, std::size_t index);
  ~NullCall();
  NullCall(const NullCall &) = delete;
  NullCall &operator=(const NullCall &) = delete;
  [[nodiscard]] void *function() const { return m_function; }

private:
  void *m_function = nullptr;
};

/// The table is constant-initialised: constructors in an application's own libraries run before the
/// layer's and may call GL.
extern const HostTable kNullHost;

} // namespace arbiter::host
