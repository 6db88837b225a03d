#pragma once
#include <span>
#include <string>
#include <vector>

#include "tools/ctl/connection.h"

/// What `arbiter ctl` can do, a function an action.
namespace arbiter::tools::ctl {

using Words = std::vector<std::string>;

/// What an action works with.
struct Session {
  Connection &connection;
  bool json = false;                ///< answers as they came
  std::string output;               ///< of -o; empty: not given
  bool changed = false;             ///< something that is undone when the connection ends
  std::vector<std::string> watched; ///< id and file, in turn: texts that were set
  std::int64_t revision = 0;
};

/// An exit code; 0: it went well. A sentence on standard error otherwise.
using Action = int (*)(Session &session, const Words &words);

struct ActionRow {
  const char *name, *operands;
  std::size_t least, most; ///< words after the name
  Action run;
  const char *help;
};
[[nodiscard]] std::span<const ActionRow> actions();

/// \returns nullptr after a complaint.
[[nodiscard]] const ActionRow *findAction(const std::string &name);
/// Runs the action that the first word names.
[[nodiscard]] int runAction(Session &session, const Words &words);

/// Sets the program's text from a file, and says what is wrong with it.
[[nodiscard]] int setText(Session &session, const std::string &id, const std::string &file);
/// The answer on standard output as JSON.
void printJson(const wire::Json &answer);
/// Says why; returns the code.
int fail(const Failure &failure);

// The actions, by file.
int listPrograms(Session &session, const Words &words);
int getText(Session &session, const Words &words);
int setProgram(Session &session, const Words &words);
int resetPrograms(Session &session, const Words &words);
int enableProgram(Session &session, const Words &words);
int disableProgram(Session &session, const Words &words);
int listParameters(Session &session, const Words &words);
int setParameter(Session &session, const Words &words);
int exportFolder(Session &session, const Words &words);
int listTextures(Session &session, const Words &words);
int getTexture(Session &session, const Words &words);
int setTexture(Session &session, const Words &words);
int takeFrame(Session &session, const Words &words);
int pickDraws(Session &session, const Words &words);
int tracePixel(Session &session, const Words &words);
int measureFrame(Session &session, const Words &words);
int showStats(Session &session, const Words &words);

} // namespace arbiter::tools::ctl
