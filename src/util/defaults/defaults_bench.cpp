// Measures what the first use of GL in a process pays for the defaults of programs: it reads and
// matches the files once, as the layer does. Prints the median of many runs in microseconds, and
// the first run, as a process makes only one.
//
// usage: defaults_bench FOLDER
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "util/defaults/choice.h"
#include "util/defaults/folders.h"

int main(int argc, char **argv) {
  using namespace arbiter::defaults;
  if (argc != 2) {
    std::fputs("usage: defaults_bench FOLDER\n", stderr);
    return 1;
  }
  std::vector<double> times;
  std::size_t entries = 0;
  for (int i = 0; i < 200; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const Facts facts = ownFacts();
    const Choice choice =
        choose(programOf(facts), readFolders({{argv[1]}, {"/etc/arbiter/defaults.d"}}),
               [](const char *name) -> const char * { return std::getenv(name); });
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
    times.push_back(took.count());
    entries = choice.files.empty() ? 0 : choice.files.front().entries.size();
  }
  const double first = times.front();
  std::nth_element(times.begin(), times.begin() + 100, times.end());
  std::printf("%zu entries: first %.0f us, median %.0f us\n", entries, first, times[100]);
  return entries == 0 ? 1 : 0;
}
