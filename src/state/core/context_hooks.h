#pragma once
#include <string_view>

namespace arbiter::fp {
struct CheckResult;
}

/// Calls from a room into one above it (docs/design/architecture.md names the order of the rooms).
namespace arbiter::state {

struct CoreContext;
struct CompiledProgram;
struct ProgramObject;
struct Refusal;

/// The functions of higher rooms that lower ones need. One table serves all contexts
/// (lifecycle/context_hooks.h).
struct ContextHooks {
  /// Deletes this context's linked programs of a program that left its object.
  void (*dropLinkedPrograms)(CoreContext &context, const CompiledProgram &compiled);
  /// Makes RasterContext::software, once, where the rasterizer is to be used.
  void (*engageRasterizer)(CoreContext &context);
  /// True if RasterContext::software may come to be made, by the settings and the host.
  bool (*mayUseRasterizer)(const CoreContext &context);
  /// True if the rasterizer draws now: it is engaged and not backed off.
  bool (*rasterizerDraws)(const CoreContext &context);
  /// Makes the next draw choose its pipeline anew.
  void (*forgetPipeline)(CoreContext &context);
  /// Gives the host all pixels that the rasterizer holds. \param name the command, for logs
  void (*synchronise)(CoreContext &context, const char *name);
  /// Adds a program string, as the compiler judged it, to the statistics.
  /// \param refusal empty where it loads, or the host would not load it either
  void (*noteLoadedProgram)(const CoreContext &context, const ProgramObject &object,
                            std::string_view text, const fp::CheckResult &result,
                            const Refusal &refusal);
  /// Adds a shader made by commands to the statistics; `compiled` is null where `error` says why.
  void (*noteShader)(const CoreContext &context, const ProgramObject &object,
                     const CompiledProgram *compiled, std::string_view error);
};

} // namespace arbiter::state
