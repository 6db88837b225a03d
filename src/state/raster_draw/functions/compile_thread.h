#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

/// A thread that compiles, so that the drawing thread waits little or not at all.
namespace arbiter::state {

/// When to compile. AfterFrame is for code that the process's first frame does without, because the
/// host draws it. The host compiles then too, and two processors may be halves of one.
enum class When : std::uint8_t { Soon, AfterFrame };

/// Runs `task` on the compiling thread, which starts at the first call. A forked child starts its
/// own thread, and loses the tasks that waited in the parent. Returns false, and drops the task, if
/// no thread can be started.
///
/// Nothing waits for the thread when the process ends. A signal handler may have called exit()
/// while a frame below it holds this queue, and a compilation may take long. What the thread uses
/// is never destroyed, including LLVM's statics (back/llvm/engine/no_exit.cpp).
bool compileLater(std::function<void()> task, When when = When::Soon);
/// Notes the end of a frame. Only the first call takes a lock.
void frameEndsForCompiler();
/// Waits until nothing is left to compile, at most `atMost`.
void awaitCompiler(std::optional<std::chrono::milliseconds> atMost);

} // namespace arbiter::state
