#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "apps/tools/ctl/connection.h"

/// Implements the actions of `arbiter ctl`, one function each.
namespace arbiter::tools::ctl {

using Words = std::vector<std::string>;

/// The state that actions share.
struct Session {
  Connection &connection;
  bool json = false;                ///< print answers unchanged
  std::string output;               ///< value of -o; empty: not given
  bool changed = false;             ///< true if a change was made that ends with the connection
  std::vector<std::string> watched; ///< alternating id and file of the texts that were set
  std::int64_t revision = 0;
};

/// Runs an action. Returns 0, or an exit code after a complaint on standard error.
using Action = int (*)(Session &session, const Words &words);

struct ActionRow {
  const char *name, *operands;
  std::size_t least, most; ///< number of words after the name
  Action run;
  const char *help;
};
[[nodiscard]] std::span<const ActionRow> actions();

/// Returns the action of that name.
/// \returns nullptr after a complaint.
[[nodiscard]] const ActionRow *findAction(const std::string &name);
/// Runs the action that the first word names.
[[nodiscard]] int runAction(Session &session, const Words &words);

/// Returns the id of the only program that begins with a word: "0c51" for "0c51f6….fp". A word with
/// all digits and an ending is returned as it is.
[[nodiscard]] Result<std::string, Failure> wholeId(Session &session, const std::string &word);
/// Sets a program's text from a file, and reports its errors.
[[nodiscard]] int setText(Session &session, const std::string &id, const std::string &file);
/// Prints the answer as JSON on standard output.
void printJson(const wire::Json &answer);
/// Prints the failure's message and returns its code.
int fail(const Failure &failure);
/// Prints an answer as JSON if that is asked for, else by `print`; complains of a failure.
int show(Session &session, Result<wire::Json, Failure> answer,
         const std::function<void(const wire::Json &)> &print);
/// Returns a text in an answer; "" if there is none.
[[nodiscard]] std::string textAt(const wire::Json &object, const char *name);
/// Returns the objects of an array in an answer.
[[nodiscard]] std::vector<wire::Json> objectsAt(const wire::Json &object, const char *name);

// The actions, grouped by file.
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
