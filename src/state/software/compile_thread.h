#pragma once
#include <chrono>
#include <functional>

/// One thread that compiles, so that the drawing thread need not, or not for long.
namespace arbiter::state::software {

/// Runs `task` on the compiling thread, which starts at the first call with all signals blocked. In
/// a child after a fork the thread is started anew, and what was waiting in the parent is lost
/// there. False, and the task is gone, where no thread can be started or the process is ending.
bool compileLater(std::function<void()> task);
/// Until nothing is left to compile, or for so long.
void awaitCompiler(std::chrono::milliseconds atMost);

} // namespace arbiter::state::software
