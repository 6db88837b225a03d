#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

/// One thread that compiles, so that the drawing thread need not, or not for long.
namespace arbiter::state::software {

/// AfterFrame: what the first frame of the process does without, as the host draws it, is compiled
/// once it has ended. The host compiles too, and processors may be two halves of one.
enum class When : std::uint8_t { Soon, AfterFrame };

/// Runs `task` on the compiling thread, which starts at the first call. In a child after a fork the
/// thread is started anew, and what was waiting in the parent is lost there. False, and the task is
/// gone, where no thread can be started.
///
/// Nothing waits for the thread when the process ends: exit() may have been called by a signal's
/// handler, above a frame that holds this very queue, and a compilation may take long. What it uses
/// is never destroyed, LLVM's own statics included (back/llvm/engine/no_exit.cpp).
bool compileLater(std::function<void()> task, When when = When::Soon);
/// A frame ended. Takes no lock but the first time.
void frameEndsForCompiler();
/// Until nothing is left to compile, or for `atMost`.
void awaitCompiler(std::optional<std::chrono::milliseconds> atMost);

} // namespace arbiter::state::software
