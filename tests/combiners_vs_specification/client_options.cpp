#include "client_options.h"

#include <CLI/CLI.hpp>

std::optional<int> parseOptions(int argc, char **argv, const char *about, Seeds &seeds,
                                std::initializer_list<Flag> flags) {
  CLI::App app(about);
  app.add_option("--first", seeds.first, "the first seed")->capture_default_str();
  app.add_option("--count", seeds.count, "how many seeds")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  for (const Flag &flag : flags)
    app.add_flag(flag.name, flag.value, flag.help);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    return app.exit(error);
  }
  return std::nullopt;
}
