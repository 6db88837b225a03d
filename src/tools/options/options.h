#pragma once
#include <string>

#include "tools/commands.h"

namespace CLI {
class App;
} // namespace CLI

/// The verbs of `arbiter` with their options, as CLI11 has them.
namespace arbiter::tools {

/// Everything that a command line can ask for.
struct Arguments {
  CheckArguments check;
  CompileArguments compile;
  DrawArguments draw;
  DebugArguments debug;
  RunArguments run;
  DefaultsArguments defaults;
  DoctorArguments doctor;
  StatsArguments stats;
  CaptureArguments capture;
  ReportArguments report;
  ProfilesArguments profiles;
  CacheArguments cache;
  CtlArguments ctl;
  RenderArguments render;
  LspArguments lsp;
  BuilderArguments builder;
};

/// The group, in help, of the options that verbs which load the layer share.
inline constexpr const char *kLayerGroup = "Options of the layer";

/// Adds every verb; parsing fills \p arguments, which must outlive the application.
void addVerbs(CLI::App &app, Arguments &arguments);

/// Says of what a parsed command line gives the first option that has no effect beside the others:
/// "--why has no effect with --json". Empty if each has one.
[[nodiscard]] std::string withoutEffect(const CLI::App &verb);

} // namespace arbiter::tools
