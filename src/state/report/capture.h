#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "state/objects/target.h"
#include "state/report/capture_record.h"

/// The interface by which a context reports to the record of ARBITER_CAPTURE. Nothing is done per
/// draw: a program's draws are how far the path's counter moved while the program was effective.
/// Its parameters are those that the host still holds when it leaves. Its textures are queried when
/// it becomes effective, as applications often bind the next program's textures before they change
/// the program.
namespace arbiter::state {

struct CoreContext;
struct ProgramObject;

/// True if ARBITER_CAPTURE is set. Costs one load of a constant.
[[nodiscard]] inline bool capturing() {
  static const bool s_capturing = CaptureRecord::instance() != nullptr;
  return s_capturing;
}

void captureContextMade(CoreContext &context);
/// Forgets a context that is about to be freed. It may be current on no thread.
void captureContextGone(CoreContext &context);
/// Records a program string that the layer compiled; `compiled` is null if it was refused.
void captureLoad(const CoreContext &context, const ProgramObject &object, std::string_view text,
                 const fp::CheckResult &result, const CompiledProgram *compiled);
/// Records that programs became effective. The context is current.
void captureEnter(CoreContext &context);
/// Records the draws of the effective programs, before others may be chosen.
void captureLeave(CoreContext &context);
/// Counts a frame, at SwapBuffers.
void captureFrame(CoreContext &context);

} // namespace arbiter::state
