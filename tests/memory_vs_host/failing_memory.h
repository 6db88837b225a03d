#pragma once

/// The interface of libfailing_memory.so, which a client looks up if it is preloaded.
extern "C" {
/// Starts counting the layer's allocations. Number `at` (from 1) fails, and with `forGood` all
/// later ones; 0: none fails.
void failing_memory_arm(long at, int forGood);
/// Stops. \return how many have failed \param made how many were requested
long failing_memory_disarm(long *made);
}
