#pragma once
#include <string>
#include <string_view>
#include <vector>

/// What a shell may complete a word to, from the tables that the verbs work with.
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
/// Of `arbiter ctl`.
[[nodiscard]] Candidates actions();
/// Processes that listen to `arbiter ctl`.
[[nodiscard]] Candidates processes();
/// Programs that such a process has loaded; 0: the only one that listens. Nothing if it does not
/// answer at once: a shell waits.
[[nodiscard]] Candidates programs(int process);
/// What an action's operand of that number is, from 0: "ID", "FILE"; empty: it has none.
[[nodiscard]] std::string operandOf(std::string_view action, std::size_t number);

} // namespace arbiter::tools::complete
