#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Completions of a word for shells, from the tables that the verbs work with.
namespace arbiter::tools::complete {

struct Candidate {
  std::string word;
  std::string help; ///< one line
};
using Candidates = std::vector<Candidate>;

/// Built-in profiles, by their own names and by what people call the cards.
[[nodiscard]] Candidates profiles();
/// `gallery:NAME` of each document.
[[nodiscard]] Candidates gallery();
/// Words of `draw --texture` for an image.
[[nodiscard]] Candidates images();
/// The actions of `arbiter ctl`.
[[nodiscard]] Candidates actions();
/// Processes that listen to `arbiter ctl`.
[[nodiscard]] Candidates processes();
/// Programs that such a process has loaded; 0: the only one that listens. Nothing if it does not
/// answer at once: a shell waits.
[[nodiscard]] Candidates programs(int process);
/// The kind of an action's operand, counted from 0: "ID", "FILE"; empty: it has none.
[[nodiscard]] std::string operandOf(std::string_view action, std::size_t number);

} // namespace arbiter::tools::complete
