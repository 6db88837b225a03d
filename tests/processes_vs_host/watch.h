#pragma once

/// What a signal's handler can know of the code that it interrupted. The host's own locks, and
/// malloc's, hang exit() in such a handler without a layer as well (one run of thirty); a row that
/// asks exit() of a process where neither is held asks it of the layer alone.
namespace foreign {

/// To be called once, before the first signal.
void prepareWatch();
/// The layer is in this process.
bool isLayerLoaded();
/// In a handler: all frames below are this program's, the layer's or libc's, none the host's, and
/// no allocation is under way on this thread.
bool interruptedOutsideHost();
/// And one of them is the layer's.
bool interruptedInLayer();
/// From here on, this thread ends the process with 9, and a line that says so, where the layer's
/// libraries allocate or free in it, lock a mutex or join a thread: malloc's lock, and any of the
/// layer's, may be held by what a handler interrupted.
void watchLayer();

} // namespace foreign
