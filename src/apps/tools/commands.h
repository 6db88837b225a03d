#pragma once
#include <optional>
#include <string>
#include <vector>

#include "util/text/exit_codes.h"

/// One function for each subcommand of `arbiter`. cli.cpp alone parses the command line and fills
/// these structures. Each function returns the process's exit code.
namespace arbiter::tools {

struct CheckArguments {
  std::vector<std::string> profiles; ///< one; two only to compare one file under both
  std::string limits = "enforce";    ///< or "report"
  std::string language = "auto";     ///< by the header; or a name of languageRows()
  std::string gauges = "auto";       ///< or "always", "never": styleOf() of check/terminal.h
  bool json = false;
  bool brief = false; ///< first lines of diagnostics only, no counts
  bool why = false;   ///< every reason, for every file
  bool compare = false;
  bool advise = false;            ///< show changes that lower the counts
  bool fix = false;               ///< apply them to the files
  std::vector<std::string> files; ///< files and folders
};
[[nodiscard]] int check(const CheckArguments &arguments);

struct CompileArguments {
  std::string profile;
  std::string emit = "glsl";     ///< "tokens", "ir", "assembly", "glsl" or "native"
  std::string language = "auto"; ///< by the header; or a name of languageRows()
  std::string numerics = "host"; ///< glsl, and the passes; a name of fp::kNumericsNames
  bool optimise = false;         ///< ir: after the passes
  bool json = false;             ///< print the output and the diagnostics as one JSON document
  std::string output = "-";
  std::string file;
};
[[nodiscard]] int compile(const CompileArguments &arguments);

/// Options that set the layer's environment, common to `run` and `draw`.
struct LayerArguments {
  std::string library; ///< empty: found beside the executable or in the installation
  std::string profile; ///< empty: from the environment
  std::string limits;
  std::string identity;
  std::string numerics;
  std::string backend;
  std::string fixedFunction;
  std::string attributes;
  std::string extensionsMaxYear;
  std::string extensionsMaxLength;
  std::vector<std::string> extensions; ///< "GL_NAME=on"
  std::string stats;
  std::string log;
  std::string debug;
  std::string hostVendor;
  std::string capture; ///< a folder, existing when the command starts
  std::string replace; ///< a folder, existing when the command starts
  bool control = false;
  std::string hud; ///< "true", or a value of ARBITER_HUD; empty: none
};

struct RunArguments {
  LayerArguments layer;
  bool printEnvironment = false; ///< print the assignments instead of running the command
  std::vector<std::string> command;
};
[[nodiscard]] int run(const RunArguments &arguments);

struct DefaultsArguments {
  std::string check; ///< a file to test instead of the installed ones
  bool json = false;
  std::vector<std::string> command; ///< empty: list all
};
/// Shows the defaults of programs: all of them, those of a command, or those of a file.
[[nodiscard]] int showDefaults(const DefaultsArguments &arguments);

struct DoctorArguments {
  std::string library; ///< the layer; empty: found as for `run`
  std::string root;    ///< root of the file system to examine; empty: this system's
  bool run = false;    ///< also run the command
  double seconds = 5;  ///< how long to run it
  bool json = false;
  std::vector<std::string> command;
};
/// Explains why the layer does not reach a command.
[[nodiscard]] int diagnose(const DoctorArguments &arguments);

struct StatsArguments {
  std::vector<std::string> files; ///< values of ARBITER_STATS, with %p
  bool json = false;
};
/// Completes the statistics of processes that were killed, unless another process already has.
/// Prints the figures of all statistics that are there, and their sum.
[[nodiscard]] int sumStatistics(const StatsArguments &arguments);

struct CaptureArguments {
  LayerArguments layer;
  std::string folder;     ///< empty: named after the command
  bool indexOnly = false; ///< rebuild the index of a folder and run nothing
  std::vector<std::string> command;
};
/// Runs the command and writes an index of the programs that it loaded.
[[nodiscard]] int capture(const CaptureArguments &arguments);

struct ReportArguments {
  std::string profile;                ///< empty: the capture's, or the user's
  std::string output = "report.html"; ///< "-": standard output
  bool json = false;                  ///< print the same as JSON
  std::vector<std::string> operands;  ///< files, folders, or one capture
};
/// Writes one HTML page about a set of programs.
[[nodiscard]] int report(const ReportArguments &arguments);

struct DrawArguments {
  LayerArguments layer;
  std::vector<std::string> files;    ///< a document, or a vertex program and a fragment program
  std::string size;                  ///< empty: the document's
  std::string mesh;                  ///< a shape's word; empty: the document's
  std::vector<std::string> textures; ///< "N=IMG.png|checker|noise"
  std::vector<std::string> locals;   ///< "[vp:|fp:]N=x,y,z,w"
  std::vector<std::string> envs;
  std::vector<std::string> attribs; ///< "N=x,y,z,w"
  int frames = 1;                   ///< number of frames, drawn from frame 0
  int frame = -1;                   ///< the only frame to draw, from 0; -1: all
  int feedback = -1;                ///< texture unit that receives each frame's picture, or -1
  std::string output;               ///< empty: the document's name with the ending .png
  bool opaque = false;              ///< set the picture's alpha to 1
  bool json = false;
  bool bare = false;    ///< without the layer, on the host's implementation
  bool inLayer = false; ///< true in the process with the preloaded layer
};
/// Draws a scene or programs into a PNG file.
/// \param argv the whole command line, which is executed again under the layer
[[nodiscard]] int draw(const DrawArguments &arguments, const std::vector<std::string> &argv);

struct DebugArguments {
  std::string document;
  std::vector<std::string> textures; ///< as of `draw`
  std::string pixel;                 ///< "X,Y", y up from the lower left; empty: the middle
  bool fromTop = false;              ///< Y counts down from the upper left
  std::string against = "swrast";    ///< or "host", "bare", "fp24", or another program's file
  std::string watch;                 ///< "REG@LINE", or empty
  std::string range = "0,1";         ///< of --watch: what becomes black, and white
  std::string output;                ///< of --watch; empty: no picture
  std::string breakOn;               ///< debug/trace/condition.h, or empty
  int line = 0;                      ///< run to it; 0: to the end
  int pass = 1;
  int frame = 0;
  std::string stage = "fragment"; ///< or "vertex"
  bool json = false;
  std::string profile;
  std::string numerics; ///< empty: the document's, or host
  std::string library;
};
/// Shows how a program computes one pixel.
[[nodiscard]] int debugPixel(const DebugArguments &arguments);
/// The hidden verb that runs drawForDebugger(); no help shows it.
inline constexpr const char *kDrawsVerb = "debug-draws";
/// Runs the process that draws for debugPixel(), as a server (draws/server.h) on descriptor 0.
[[nodiscard]] int drawForDebugger();
struct RenderArguments {
  LayerArguments layer;
  std::string folder = "."; ///< base folder of file names in documents
  int descriptor = -1;      ///< a connected socket; -1: listen
  bool bare = false;        ///< without the layer
  bool inLayer = false;     ///< true in the process with the preloaded layer
};
/// Draws documents for the process at the other end of a socket (docs/write/control.md).
/// \param argv the whole command line, which is executed again under the layer
[[nodiscard]] int render(const RenderArguments &arguments, const std::vector<std::string> &argv);

struct CtlArguments {
  int process = 0; ///< 0: the only one that listens
  bool json = false;
  std::string output;
  double timeout = 5;             ///< seconds to wait for an answer
  double holdSeconds = 0;         ///< 0: until this process is ended
  std::vector<std::string> words; ///< the action and its operands
};
/// Controls a process that was started under control.
[[nodiscard]] int controlProcess(const CtlArguments &arguments);
/// Returns the actions, one per line, for the help text.
[[nodiscard]] std::string ctlActions();

struct CacheArguments {
  bool json = false;
  bool clear = false;
};
[[nodiscard]] int cache(const CacheArguments &arguments);

struct LspArguments {
  std::string profile;
};
/// Runs a language server on standard input and output (lsp/server.h).
[[nodiscard]] int serve(const LspArguments &arguments);

struct BuilderArguments {
  std::string document;   ///< a program or a folder; empty: none
  std::string screenshot; ///< PNG file for a picture of the window, which then exits; empty: none
  std::string size;       ///< "WxH" of the picture; empty: 1280x800
  bool small = false;     ///< the picture has few colours
  std::string colors;     ///< "system", "light" or "dark"; empty: as before
  std::string panel;      ///< to bring to the front; empty: by the document
  std::string edit;       ///< "FROM=>TO": what a picture shows replaced
  std::string pixel;      ///< "X,Y", to debug
  std::string watch;      ///< a line
  std::string attach;     ///< the number of a process
};
/// Replaces this process with `arbiter-builder`, the window, which is installed beside this
/// command.
[[nodiscard]] int builder(const BuilderArguments &arguments);

struct ProfilesArguments {
  std::string name; ///< empty: list all
  bool json = false;
};
[[nodiscard]] int profiles(const ProfilesArguments &arguments);

} // namespace arbiter::tools
