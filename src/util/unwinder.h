#pragma once

namespace arbiter {

/// Prepares the statically linked unwinder for frames that another unwinder unwinds. Call it once,
/// when the library is loaded. A cancelled thread, or an application's exception out of a callback
/// or an error handler, unwinds the layer's frames with libgcc_s.so. Cleanups there use the layer's
/// own copy, whose register table is empty until its first throw: without this call that ended the
/// process.
void prepareUnwinder();

} // namespace arbiter
