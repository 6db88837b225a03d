#pragma once
#include <string>
#include <string_view>

namespace arbiter::fp {
struct CheckResult;
}

/// The statistics of the process (ARBITER_STATS, `arbiter run --stats`) as JSON: contexts,
/// programs, draws by path with the reasons for fall-backs, feedback copies. They are written at
/// exit. Until then they are in a record that outlives the process (util/record/live_record.h),
/// which is updated at the end of each frame and at rare events.
namespace arbiter::state {

struct RasterContext;
struct CoreContext;
struct CompiledProgram;
struct ProgramObject;
struct Refusal;

void noteContextCreated(RasterContext &context);
/// Adds the counters of a context that is about to be freed to those of freed contexts.
void noteContextDestroyed(const RasterContext &context);
/// Updates the record at the end of a context's frame, and when it is first current.
void noteProgress(const RasterContext &context);
/// Adds a program string that the layer compiled, if statistics are asked for.
/// \param refusal empty if it loads, or if the host would not load it either
void noteLoadedProgram(const CoreContext &context, const ProgramObject &object,
                       std::string_view text, const fp::CheckResult &result,
                       const Refusal &refusal);
/// Adds a shader at EndFragmentShaderATI, like a loaded program. If `compiled` is null, `error`
/// says why.
void noteFragmentShader(const CoreContext &context, const ProgramObject &object,
                        const CompiledProgram *compiled, std::string_view error);

/// Returns the present statistics, even if none were asked for. Programs are listed only if they
/// were.
[[nodiscard]] std::string statisticsJson();

/// Writes the statistics to the file of ARBITER_STATS, if set. The new file replaces the old one
/// atomically, with mode 0600; a symbolic link is not followed. `%p` in the name stands for the
/// process id. The rasterizer's figures of a context that is current in another thread are those of
/// its last frame. A forked child writes to FILE.PID, to keep the parent's figures. So does a
/// process that finds the file written by another since it began. Called at exit; more calls are
/// harmless. It allocates nothing and waits for no lock, as a signal handler may call exit() above
/// a function of the layer or of the allocator.
void writeStatistics();

} // namespace arbiter::state
