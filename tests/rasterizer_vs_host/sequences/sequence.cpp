// Issues random sequences of GL commands; a seed gives the same sequence everywhere.
//   rasterizer-sequence SEED COUNT            the first COUNT commands
//   rasterizer-sequence SEED COUNT 3,17,20    only those of them
//   rasterizer-sequence --names SEED COUNT    prints their names
// Writes everything read as records: a line "what TAB bytes", then the bytes.
#include "random_commands.h"
#include "world.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

namespace {

using namespace software;

const Command &commandOf(Random &random) {
  static const std::vector<Command> s_all = [] {
    std::vector<Command> all = kDrawCommands;
    all.insert(all.end(), kPixelCommands.begin(), kPixelCommands.end());
    all.insert(all.end(), kStateCommands.begin(), kStateCommands.end());
    all.insert(all.end(), kListCommands.begin(), kListCommands.end());
    return all;
  }();
  return pickByWeight(s_all, random);
}

std::string nameOf(int number, const Command &command) {
  return std::to_string(number) + " " + command.name;
}

} // namespace

int main(int argc, char **argv) {
  const bool names = argc > 1 && !std::strcmp(argv[1], "--names");
  const int first = names ? 2 : 1;
  if (argc < first + 2) {
    std::fprintf(stderr, "usage: rasterizer-sequence [--names] SEED COUNT [N,N...]\n");
    return 2;
  }
  const std::uint64_t seed = std::strtoull(argv[first], nullptr, 10);
  const int count = std::atoi(argv[first + 1]);
  const bool all = argc <= first + 2;
  const std::set<int> only = all ? std::set<int>() : numbersOf(argv[first + 2]);
  World world;
  if (!names && !world.open())
    return 1;
  // Some programs ask for errors after each command, others never.
  const bool checks = Random(seed).once(2);
  for (int number = 0; number < count; ++number) {
    if (!all && !only.contains(number))
      continue;
    Random random = randomOf(seed, number);
    const Command &command = commandOf(random);
    const std::string what = nameOf(number, command);
    if (names) {
      std::printf("%s\n", what.c_str());
      continue;
    }
    command.run(world, random, what);
    if (checks) {
      if (const std::string errors = takeErrors(); !errors.empty())
        record(what + " errors" + errors, {});
    }
  }
  if (names)
    return 0;
  record("errors" + takeErrors(), {});
  world.recordAll();
  return 0;
}
