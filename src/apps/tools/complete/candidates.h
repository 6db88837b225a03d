#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Lists completions of a word for shells, from the tables that the verbs use.
namespace arbiter::tools::complete {

struct Candidate {
  std::string word;
  std::string help; ///< one line
};
using Candidates = std::vector<Candidate>;

/// Returns the built-in profiles, by their names and by the common names of the cards.
[[nodiscard]] Candidates profiles();
/// Returns `gallery:NAME` for each document of the gallery.
[[nodiscard]] Candidates gallery();
/// Returns the words of `draw --texture` for images.
[[nodiscard]] Candidates images();
/// Returns the actions of `arbiter ctl`.
[[nodiscard]] Candidates actions();
/// Returns the processes that listen to `arbiter ctl`.
[[nodiscard]] Candidates processes();
/// Returns the programs that a process has loaded. 0 means the only one that listens. Returns
/// nothing if the process does not answer at once, because the shell is waiting.
[[nodiscard]] Candidates programs(int process);
/// Returns the kind of an action's operand, such as "ID" or "FILE", or "" if there is none.
/// \param number counted from 0
[[nodiscard]] std::string operandOf(std::string_view action, std::size_t number);

} // namespace arbiter::tools::complete
