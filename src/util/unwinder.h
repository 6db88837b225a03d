#pragma once

namespace arbiter {

/// Makes the unwinder that is linked into this library ready for frames that another one unwinds:
/// to be called once, when the library is loaded. A thread that is cancelled in a wait of the
/// host's, or an application's exception out of a callback or an error handler, passes frames of
/// the layer's under libgcc_s.so, and cleanups there ask the layer's own copy, whose table of
/// registers is empty until its first throw: it ended the process.
void prepareUnwinder();

} // namespace arbiter
