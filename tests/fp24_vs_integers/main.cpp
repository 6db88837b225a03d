// fp24-proof: compares the interpreter's 24-bit arithmetic with exact integers. See --help.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <unistd.h>

#include "suites.h"
#include "util/json.h"

namespace {
using namespace arbiter::fp::proof;

constexpr const char *kHelp =
    "usage: fp24-proof [--suite formats|unary|sampled|programs] [--stride N] [--samples N]\n"
    "                  [--seed S] [--json FILE]\n"
    "\n"
    "Holds the 24-bit mode (ir/semantics.h, Fp24) against its definition in integers without "
    "error;\n"
    "COS EX2 LG2 SIN against long double. All suites unless one is named.\n"
    "  --stride N    every Nth of the 2^24 patterns and of the 2^32 singles (1: all, minutes)\n"
    "  --samples N   of each opcode, and of programs (1000000)\n"
    "Exit status: 0 all equal to the bit, 1 not, 2 bad usage.\n";

struct Suite {
  const char *name;
  Rows (*run)(const Settings &);
};
constexpr Suite kSuites[] = {
    {"formats", formats}, {"unary", unary}, {"sampled", sampled}, {"programs", programs}};

struct Arguments {
  Settings settings;
  std::string suite, json;
};

bool parse(int argc, char **argv, Arguments &arguments) {
  arguments.settings.samples = 1000000;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string flag = argv[i], value = argv[i + 1];
    if (flag == "--suite")
      arguments.suite = value;
    else if (flag == "--json")
      arguments.json = value;
    else if (flag == "--stride" || flag == "--samples" || flag == "--seed") {
      char *end = nullptr;
      const std::uint64_t number = std::strtoull(value.c_str(), &end, 10);
      if (*end != '\0' || value.empty() || (flag == "--stride" && number == 0))
        return false;
      (flag == "--stride"    ? arguments.settings.stride
       : flag == "--samples" ? arguments.settings.samples
                             : arguments.settings.seed) = number;
    } else
      return false;
  }
  if (argc % 2 == 0)
    return false;
  for (const Suite &suite : kSuites)
    if (arguments.suite.empty() || arguments.suite == suite.name)
      return true;
  return false;
}

void show(const std::string &name, double done) {
  std::fprintf(stderr, "\r%-28s %3.0f %%", name.c_str(), 100 * done);
}

void print(const Row &row) {
  std::printf("%-28s %11llu cases %8llu different %6llu open\n", row.name.c_str(),
              (unsigned long long)row.cases, (unsigned long long)row.different,
              (unsigned long long)row.open);
  if (!row.first.empty())
    std::printf("  %s\n", row.first.c_str());
  std::fflush(stdout);
}
} // namespace

int main(int argc, char **argv) {
  if (argc == 2 && std::strcmp(argv[1], "--help") == 0)
    return std::fputs(kHelp, stdout), 0;
  Arguments arguments;
  if (!parse(argc, argv, arguments))
    return std::fputs(kHelp, stderr), 2;
  const bool terminal = isatty(STDERR_FILENO);
  if (terminal)
    arguments.settings.progress = show;
  bool equal = true;
  arbiter::JsonWriter json;
  json.beginObject().key("schema").value(1).key("stride").value(arguments.settings.stride);
  json.key("samples").value(arguments.settings.samples).key("suites").beginObject();
  for (const Suite &suite : kSuites) {
    if (!arguments.suite.empty() && arguments.suite != suite.name)
      continue;
    const auto start = std::chrono::steady_clock::now();
    const Rows rows = suite.run(arguments.settings);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (terminal)
      std::fputs("\r\033[K", stderr);
    std::printf("%s, %.1f s\n", suite.name, seconds.count());
    json.key(suite.name).beginObject().key("seconds").value(seconds.count());
    json.key("rows").beginArray();
    for (const Row &row : rows) {
      print(row);
      equal = equal && row.different == 0 && row.cases != 0;
      json.beginObject().key("name").value(row.name).key("cases").value(row.cases);
      json.key("different").value(row.different).key("open").value(row.open);
      json.key("first").value(row.first).endObject();
    }
    json.endArray().endObject();
  }
  json.endObject().endObject();
  if (!arguments.json.empty() && !(std::ofstream(arguments.json) << json.take()))
    return std::fprintf(stderr, "cannot write %s\n", arguments.json.c_str()), 2;
  return equal ? 0 : 1;
}
