// Issues random sequences of commands of several contexts; a seed gives the same sequence
// everywhere.
//   sharing-model [--windows] [--whole] FIRST COUNT COMMANDS        that many seeds
//   sharing-model [--windows] [--whole] SEED 1 COMMANDS 3,17,20     only those commands of one
//   sharing-model --names SEED 1 COMMANDS [...]                     prints their names
// Each read is printed as a line "seed number command TAB bytes hash", or with --whole as records
// of software::record(). A line "seed end" follows each sequence.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>

#include "../rasterizer_vs_host/random_commands.h"
#include "world.h"

namespace {

using namespace sharing;

const Command &commandOf(Random &random) {
  static const std::vector<Command> s_all = [] {
    std::vector<Command> all;
    for (const auto *some : {&kContextCommands, &kTextureCommands, &kDrawCommands, &kBufferCommands,
                             &kProgramCommands})
      all.insert(all.end(), some->begin(), some->end());
    return all;
  }();
  return software::pickByWeight(s_all, random);
}

struct Options {
  bool windows = false, names = false;
  int commands = 0;
  bool all = true;
  std::set<int> only;
};

void runSequence(Platform &platform, Workers &workers, std::uint64_t seed, const Options &options) {
  World world(platform, workers);
  Random opening(seed);
  world.open(opening);
  // Some programs ask for errors after each command, others never.
  const bool checks = opening.once(2);
  const std::string prefix = std::to_string(seed) + " ";
  for (int number = 0; number < options.commands; ++number) {
    if (!options.all && !options.only.contains(number))
      continue;
    Random random = software::randomOf(seed, number);
    const Command &command = commandOf(random);
    const std::string what = prefix + std::to_string(number) + " " + command.name;
    if (command.ofContexts)
      command.run(world, random, what);
    else
      world.here([&] { command.run(world, random, what); });
    if (checks)
      world.here([&] {
        if (const std::string errors = software::takeErrors(); !errors.empty())
          record(what + " errors" + errors, {});
      });
  }
  for (int i = 0; i < world.contexts(); ++i) {
    world.handOn(i, i % Workers::kThreads, i, World::Ending::Finish, true);
    world.here([&] {
      const std::string what = prefix + "end context " + std::to_string(i);
      record(what + " errors" + software::takeErrors(), {});
      world.recordAll(what);
    });
  }
  world.close();
  record(prefix + "end", {});
  std::fflush(stdout);
}

void printNames(std::uint64_t seed, const Options &options) {
  for (int number = 0; number < options.commands; ++number) {
    if (!options.all && !options.only.contains(number))
      continue;
    Random random = software::randomOf(seed, number);
    std::printf("%d %s\n", number, commandOf(random).name);
  }
}

} // namespace

int main(int argc, char **argv) {
  Options options;
  int at = 1;
  for (; at < argc && !std::strncmp(argv[at], "--", 2); ++at) {
    if (!std::strcmp(argv[at], "--windows"))
      options.windows = true;
    else if (!std::strcmp(argv[at], "--whole"))
      g_wholeRecords = true;
    else if (!std::strcmp(argv[at], "--names"))
      options.names = true;
    else
      die("there is no such option");
  }
  if (argc < at + 3)
    die("usage: sharing-model [--windows] [--whole] [--names] FIRST COUNT COMMANDS [N,N...]");
  const std::uint64_t first = std::strtoull(argv[at], nullptr, 10);
  const int count = std::atoi(argv[at + 1]);
  options.commands = std::atoi(argv[at + 2]);
  options.all = argc == at + 3;
  if (!options.all)
    options.only = software::numbersOf(argv[at + 3]);
  if (options.names) {
    printNames(first, options);
    return 0;
  }
  const std::unique_ptr<Platform> platform =
      options.windows ? makeGlxPlatform() : makeEglPlatform();
  Workers workers;
  for (int i = 0; i < count; ++i)
    runSequence(*platform, workers, first + std::uint64_t(i), options);
  return 0;
}
