#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "state/objects/target.h"
#include "state/report/capture_record.h"

/// What a context tells the record of ARBITER_CAPTURE. Nothing is done for each draw: the draws of
/// a program are the difference of the path's counter between its becoming effective and its
/// leaving, and the parameters of its last draw are what the host still holds then. Bound textures
/// are looked at when a program becomes effective: by the time it leaves, the application has often
/// bound those of the next.
namespace arbiter::state {

class Context;
struct ProgramObject;

/// Whether ARBITER_CAPTURE is set: one load of a constant.
[[nodiscard]] inline bool capturing() {
  static const bool s_capturing = CaptureRecord::instance() != nullptr;
  return s_capturing;
}

void captureContextMade(Context &context);
/// The context is about to be freed, perhaps on a thread where it is not current.
void captureContextGone(Context &context);
/// A program string was given to our compiler; `compiled` is null where it was refused.
void captureLoad(const Context &context, const ProgramObject &object, std::string_view text,
                 const fp::CheckResult &result, const CompiledProgram *compiled);
/// The programs that draws now use have been chosen; the context is current.
void captureEnter(Context &context);
/// Other programs, or none, may be chosen next.
void captureLeave(Context &context);
/// SwapBuffers.
void captureFrame(Context &context);

} // namespace arbiter::state
