#pragma once

/// What a client asks of libfailing_memory.so, which it finds where that is preloaded.
extern "C" {
/// From now on counts allocations of the layer; number `at` (from 1) fails, and with `forGood` all
/// behind it. 0: none fails.
void failing_memory_arm(long at, int forGood);
/// Stops. \return how many have failed \param made how many were asked for
long failing_memory_disarm(long *made);
}
