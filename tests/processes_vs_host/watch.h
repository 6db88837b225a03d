#pragma once

/// Tells a signal handler about the code that it interrupted. If that holds the host's locks or
/// malloc's, exit() hangs in the handler even without a layer (in one run of thirty). A row that
/// calls exit() only when neither is held tests the layer alone.
namespace foreign {

/// Prepares the watch; call it once, before the first signal.
void prepareWatch();
/// True if the layer is in this process.
bool isLayerLoaded();
/// True in a handler if all frames below are this program's, the layer's or libc's, none the
/// host's, and this thread has no allocation in progress.
bool interruptedOutsideHost();
/// True if, in addition, one of them is the layer's.
bool interruptedInLayer();
/// Makes the process exit with 9 and a message if the layer's libraries, on this thread, allocate,
/// free, lock a mutex or join a thread from now on. The code that a handler interrupted may hold
/// malloc's lock, or one of the layer's.
void watchLayer();

} // namespace foreign
