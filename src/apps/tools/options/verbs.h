#pragma once
#include "apps/tools/options/options.h"
#include "apps/tools/options/verb.h"

/// Each function adds a verb with its options and its help.
namespace arbiter::tools {

inline constexpr const char *kProfileHelp = "a profile's name (arbiter profiles), or a TOML file";
inline constexpr const char *kChosenProfileHelp =
    "a profile's name (arbiter profiles), or a TOML file; by default the one that a text's panel "
    "names, else ARBITER_PROFILE's, else r300";

// programs.cpp
void addCheck(CLI::App &app, CheckArguments &check);
void addCompile(CLI::App &app, CompileArguments &compile);
void addReport(CLI::App &app, ReportArguments &report);
void addProfiles(CLI::App &app, ProfilesArguments &profiles);

// layer.cpp
/// Adds the options of the layer to a verb that loads it.
void addLayer(Verb &verb, LayerArguments &layer);
void addRun(CLI::App &app, RunArguments &run);
void addStats(CLI::App &app, StatsArguments &stats);
void addCapture(CLI::App &app, CaptureArguments &capture);
void addCache(CLI::App &app, CacheArguments &cache);

// programs_of_others.cpp
void addDefaults(CLI::App &app, DefaultsArguments &defaults);
void addDoctor(CLI::App &app, DoctorArguments &doctor);

// draw.cpp
void addDraw(CLI::App &app, DrawArguments &draw);
void addDebug(CLI::App &app, DebugArguments &debug);

// services.cpp
void addCtl(CLI::App &app, CtlArguments &ctl);
void addRender(CLI::App &app, RenderArguments &render);
void addLsp(CLI::App &app, LspArguments &lsp);
void addBuilder(CLI::App &app, BuilderArguments &builder);
void addHelp(CLI::App &app, std::string &verb);

} // namespace arbiter::tools
