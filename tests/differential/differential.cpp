// differential: generated programs, interpreter against pixels. See --help.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "edges.h"
#include "suite.h"
#include "util/json.h"

namespace {
using namespace arbiter::differential;

constexpr const char *kHelp =
    "usage: differential [--mode MODE] [--language arb|ati] [--count N] [--seed S] [--json "
    "FILE] [--failures DIR]\n"
    "\n"
    "Draws N (500) generated fragment programs, 16 x 16 fragments each into float buffers, and\n"
    "compares every pixel with the reference interpreter, within tolerances stated per opcode.\n"
    "  --mode glsl  through the compiler's GLSL, given to the host's GLSL compiler (default)\n"
    "  --mode arb   through the calls of ARB_fragment_program: the host's own implementation, or\n"
    "               the layer's where it is preloaded (ARBITER_PROFILE=host lifts a card's "
    "limits)\n"
    "  --language ati   ATI fragment shaders: --mode glsl, --mode arb (their text form) and\n"
    "               --mode api (ATI_fragment_shader); --mode peer is api with shaders that Mesa's\n"
    "               own implementation of it draws as the specification says\n"
    "  --suite random|edges|mutants   edges: each opcode on pairs of special values instead;\n"
    "               mutants: the interpreter is wrong on purpose, and three of five must show\n"
    "  --failures   folder for the text, the reason and a picture (drawn | expected) of failures\n"
    "Exit status: 0 all agree, 1 some differ, 2 bad usage, 77 no GL context.\n";

struct Arguments {
  std::string mode = "glsl";
  std::string json;
  bool ati = false; ///< the language
  bool edges = false;
  SuiteOptions suite;
};

bool isMode(const char *name) {
  return !std::strcmp(name, "arb") || !std::strcmp(name, "api") || !std::strcmp(name, "peer") ||
         !std::strcmp(name, "glsl");
}

bool isSuite(const char *name) {
  return !std::strcmp(name, "random") || !std::strcmp(name, "edges") ||
         !std::strcmp(name, "mutants");
}

bool parse(int argc, char **argv, Arguments &arguments) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (i + 1 == argc)
      return false;
    const char *value = argv[++i];
    if (name == "--mode" && isMode(value))
      arguments.mode = value;
    else if (name == "--language" && (!std::strcmp(value, "arb") || !std::strcmp(value, "ati")))
      arguments.ati = !std::strcmp(value, "ati");
    else if (name == "--count" && std::atoi(value) > 0)
      arguments.suite.count = std::atoi(value);
    else if (name == "--seed")
      arguments.suite.firstSeed = std::strtoull(value, nullptr, 10);
    else if (name == "--suite" && isSuite(value)) {
      arguments.edges = !std::strcmp(value, "edges");
      arguments.suite.mutate = !std::strcmp(value, "mutants");
    } else if (name == "--json")
      arguments.json = value;
    else if (name == "--failures")
      arguments.suite.failures = value;
    else
      return false;
  }
  if (arguments.ati)
    arguments.suite.subject = arguments.mode == "glsl"   ? atiSubject
                              : arguments.mode == "peer" ? atiSubjectOfPeer
                                                         : atiSubjectOfHost;
  return arguments.ati ? !arguments.edges : arguments.mode != "api" && arguments.mode != "peer";
}

std::unique_ptr<Backend> backendOf(const Arguments &arguments) {
  if (arguments.mode == "glsl")
    return glslBackend();
  if (!arguments.ati)
    return arbBackend();
  return arguments.mode == "arb" ? atiTextBackend() : atiApiBackend();
}

void writeJson(const std::string &path, const std::string &mode, const Report &report) {
  arbiter::JsonWriter json;
  json.beginObject().key("schema").value(1).key("mode").value(mode);
  json.key("renderer").value(report.renderer).key("programs").value(report.programs);
  json.key("values").value(report.compared).key("ill_conditioned").value(report.skipped);
  json.key("worst_error").value(double(report.worst)).key("failures").beginArray();
  for (const Failure &failure : report.failures)
    json.beginObject()
        .key("seed")
        .value(failure.seed)
        .key("reason")
        .value(failure.reason)
        .endObject();
  json.endArray().endObject();
  std::ofstream(path) << json.take();
}
} // namespace

int main(int argc, char **argv) {
  if (argc == 2 && !std::strcmp(argv[1], "--help")) {
    std::fputs(kHelp, stdout);
    return 0;
  }
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    std::fputs(kHelp, stderr);
    return 2;
  }
  std::string why;
  const auto host = GlHost::create(why);
  if (!host) {
    std::fprintf(stderr, "differential: no GL context: %s\n", why.c_str());
    return 77;
  }
  const auto backend = backendOf(arguments);
  const Report report =
      arguments.edges ? runEdges(*backend, arguments.suite) : runSuite(*backend, arguments.suite);
  std::printf("%-5s %-40.40s programs %4d  values %9llu  ill-conditioned %7llu  worst %.3f  "
              "failed %zu\n",
              arguments.mode.c_str(), report.renderer.c_str(), report.programs,
              static_cast<unsigned long long>(report.compared),
              static_cast<unsigned long long>(report.skipped), double(report.worst),
              report.failures.size());
  if (arguments.suite.mutate) {
    const bool noticed = report.failures.size() * 5 >= std::size_t(report.programs) * 3;
    std::printf("%zu of %d mutants noticed\n", report.failures.size(), report.programs);
    return noticed ? 0 : 1;
  }
  for (const Failure &failure : report.failures)
    std::printf("  seed %llu: %s\n", static_cast<unsigned long long>(failure.seed),
                failure.reason.c_str());
  if (!arguments.json.empty())
    writeJson(arguments.json, arguments.mode, report);
  return report.failures.empty() ? 0 : 1;
}
