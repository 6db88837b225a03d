#pragma once
#include <string>
#include <string_view>

namespace arbiter::fp {
struct CheckResult;
}

/// The statistics of the process (ARBITER_STATS, `arbiter run --stats`) as JSON: contexts,
/// programs, draws by path with the reason where they are the host's, feedback copies. Written at
/// exit; until then they lie in a record that outlives the process (util/record/live_record.h),
/// brought up to date at each frame's end and at what is rare.
namespace arbiter::state {

class Context;
struct CompiledProgram;
struct ProgramObject;
struct Refusal;

/// Version of the JSON's form; grows when a member changes its meaning or goes.
inline constexpr int kStatisticsSchema = 2;

void noteContextCreated(Context &context);
/// Adds the context's counters to those of contexts that are gone. It is about to be freed.
void noteContextDestroyed(const Context &context);
/// A frame of the context's ended, or it is current for the first time.
void noteProgress(const Context &context);
/// A program string was given to our compiler. Kept only if statistics are asked for.
/// \param refusal empty where it loads, or the host would not load it either
void noteLoadedProgram(const Context &context, const ProgramObject &object, std::string_view text,
                       const fp::CheckResult &result, const Refusal &refusal);
/// EndFragmentShaderATI: `compiled` is null where `error` says why. Kept as a loaded program is.
void noteFragmentShader(const Context &context, const ProgramObject &object,
                        const CompiledProgram *compiled, std::string_view error);

/// The statistics up to now, whether or not they were asked for; programs only if they were.
[[nodiscard]] std::string statisticsJson();

/// Writes them to the file of ARBITER_STATS, if there is one. A new file takes the old one's place
/// in one step, mode 0600; a symbolic link is not followed. A process that was forked from the one
/// that the variable was meant for writes to FILE.PID instead, as does one that finds the file
/// written by another process since it began: the first one's figures are not lost. `%p` in the
/// name is the process id. Called at exit; safe to call more than once. Allocates nothing and waits
/// for no lock, as exit() may have been called by a signal's handler above a frame of the layer's
/// or of the allocator's.
void writeStatistics();

} // namespace arbiter::state
