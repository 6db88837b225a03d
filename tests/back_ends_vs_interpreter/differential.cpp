// differential: compares generated programs' pixels with the interpreter. See --help.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "edges.h"
#include "fp_compiler/back/assembly/assembly.h"
#include "suite.h"
#include "util/json.h"
#include "vertex_suite.h"

namespace {
using namespace arbiter::differential;
namespace fp = arbiter::fp;

constexpr const char *kHelp =
    "usage: differential [--mode MODE] [--language LANGUAGE] [--suite S] [--count N]\n"
    "                    [--numerics N] [--wild 0|1] [--unwritten 0|1] [--plain 0|1] [--seed S]\n"
    "                    [--program FILE]... [--json FILE] [--failures DIR]\n"
    "\n"
    "Draws N (500) generated programs, 16 x 16 fragments or vertices each into float buffers, and\n"
    "compares every pixel with the reference interpreter, within tolerances stated per opcode.\n"
    "  --mode glsl  through the compiler's GLSL, given to the host's GLSL compiler (default)\n"
    "  --mode arb   through the calls of the ARB extensions: the host's own implementation, or\n"
    "               the layer's where it is preloaded (ARBITER_PROFILE=host lifts a card's "
    "limits)\n"
    "  --mode assembly   the same with the compiler's own text, printed from the checked program\n"
    "  --language arb, vertex   ARB_fragment_program (default), ARB_vertex_program\n"
    "  --language nv, nv-vertex   the same under NVIDIA's options; --mode arb where they are "
    "announced\n"
    "               and --mode peer there, without what NVIDIA's driver does otherwise\n"
    "  --language ati   ATI fragment shaders: --mode glsl, --mode arb (their text form) and\n"
    "               --mode api (ATI_fragment_shader); --mode peer is api with shaders that stay\n"
    "               within what the specification defines, to measure the host's own by\n"
    "  --suite random|edges|mutants   edges: each opcode on pairs of special values instead;\n"
    "               mutants: the interpreter is wrong on purpose, and three of five must show\n"
    "  --numerics host|legacy|fp24   the arithmetic; where the layer is to follow it,\n"
    "               ARBITER_NUMERICS must say the same. fp24 is not for vertex programs\n"
    "  --wild 1     arb: programs with infinities, and operands outside of functions' domains\n"
    "  --unwritten 1   arb, vertex: programs that read and leave what nothing wrote, which is zero "
    "on\n"
    "               the layer's paths, and undefined on others\n"
    "  --plain 1    a program with SWZ has the compiler's own text, where SWZ reads no constant:\n"
    "               Mesa's own compiler reads some wrong\n"
    "  --program FILE   this text in place of generated ones (its header says which stage);\n"
    "               may be given several times; a failure's seed is the number of the file, from "
    "1\n"
    "  --failures   folder for the text, the reason and a picture (drawn | expected) of failures\n"
    "Exit status: 0 all agree, 1 some differ, 2 bad usage, 77 no GL context.\n";

/// Makes a backend of an extension's API, whose implementation takes the mode from
/// ARBITER_NUMERICS.
template <std::unique_ptr<Backend> (*kCreate)()> std::unique_ptr<Backend> calls(fp::Numerics) {
  return kCreate();
}

/// One way to draw the programs of a language, and the programs that it supports.
struct WayRow {
  const char *language;
  const char *mode;
  std::unique_ptr<Backend> (*create)(fp::Numerics);
  Subject (*subject)(std::uint64_t seed);
  Subject (*unwritten)(std::uint64_t seed); ///< null: there are none
  Report (*random)(Backend &, const SuiteOptions &);
  Report (*edges)(Backend &, const SuiteOptions &); ///< null: there are none
};
constexpr WayRow kWays[] = {
    {"arb", "glsl", glslBackend, arbSubject, unwrittenSubject, runSuite, runEdges},
    {"arb", "arb", calls<arbBackend>, arbSubject, unwrittenSubject, runSuite, runEdges},
    {"arb", "assembly", calls<assemblyBackend>, arbSubject, unwrittenSubject, runSuite, runEdges},
    {"vertex", "glsl", glslBackend, vertexSubject, unwrittenVertexSubject, runVertexSuite,
     runVertexEdges},
    {"vertex", "arb", calls<arbBackend>, vertexSubject, unwrittenVertexSubject, runVertexSuite,
     runVertexEdges},
    {"vertex", "assembly", calls<assemblyBackend>, vertexSubject, unwrittenVertexSubject,
     runVertexSuite, runVertexEdges},
    {"nv", "glsl", glslBackend, nvSubject, nullptr, runSuite, nullptr},
    {"nv", "arb", calls<arbBackend>, nvSubject, nullptr, runSuite, nullptr},
    {"nv-vertex", "glsl", glslBackend, nvVertexSubject, nullptr, runVertexSuite, nullptr},
    {"nv-vertex", "arb", calls<arbBackend>, nvVertexSubject, nullptr, runVertexSuite, nullptr},
    {"nv", "peer", calls<arbBackend>, nvPeerSubject, nullptr, runSuite, nullptr},
    {"nv-vertex", "peer", calls<arbBackend>, nvVertexPeerSubject, nullptr, runVertexSuite, nullptr},
    {"ati", "glsl", glslBackend, atiSubject, nullptr, runSuite, nullptr},
    {"ati", "arb", calls<atiTextBackend>, atiSubjectOfHost, nullptr, runSuite, nullptr},
    {"ati", "api", calls<atiApiBackend>, atiSubjectOfHost, nullptr, runSuite, nullptr},
    {"ati", "peer", calls<atiApiBackend>, atiSubjectOfPeer, nullptr, runSuite, nullptr},
};

const WayRow *findWay(const std::string &language, const std::string &mode) {
  for (const WayRow &row : kWays)
    if (language == row.language && mode == row.mode)
      return &row;
  return nullptr;
}

struct Arguments {
  std::string mode = "glsl";
  std::string json;
  std::string language = "arb";
  const WayRow *way = nullptr;
  bool edges = false;
  bool wild = false;
  bool unwritten = false;
  bool plain = false;
  std::vector<std::string> programs; ///< texts of files
  SuiteOptions suite;
};

/// Returns why the mode cannot be compared in this way; empty: it can.
std::string numericsFault(const Arguments &arguments) {
  const fp::Numerics numerics = arguments.suite.numerics;
  if (arguments.language == "vertex" && numerics == fp::Numerics::Fp24)
    return "vertex programs have no fp24";
  const char *const set = std::getenv("ARBITER_NUMERICS");
  const auto layers = fp::numericsNamed(set ? set : "").value_or(fp::Numerics::Host);
  if (arguments.mode != "glsl" && layers != numerics)
    return "ARBITER_NUMERICS does not say what --numerics says";
  return "";
}

bool isSuite(const char *name) {
  return !std::strcmp(name, "random") || !std::strcmp(name, "edges") ||
         !std::strcmp(name, "mutants");
}

/// Reads a program; its header decides the language of all. Returns false, with a message, if the
/// file cannot be read.
bool readProgram(const char *path, Arguments &arguments) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) {
    std::fprintf(stderr, "differential: %s cannot be read\n", path);
    return false;
  }
  arguments.programs.push_back(std::move(text).str());
  if (fp::languageOfText(arguments.programs.back()) == fp::ir::Language::ArbVertex)
    arguments.language = arguments.language.rfind("nv", 0) == 0 ? "nv-vertex" : "vertex";
  return true;
}

/// Returns the program with the compiler's own text if it has a SWZ, which then reads no constant.
/// Mesa reads some of those wrong (back/assembly/constants.h).
Subject plainSubject(Subject subject) {
  const auto swizzles = [](const fp::ir::Instruction &each) {
    return each.op == fp::ir::Opcode::Swz;
  };
  if (!subject.program ||
      std::none_of(subject.program->code.begin(), subject.program->code.end(), swizzles))
    return subject;
  return subjectOf(subject.program->language, fp::emitAssembly(*subject.program));
}

/// Chooses the programs for the seeds. Returns false if the way has no such programs.
bool chooseSubjects(Arguments &arguments) {
  SuiteOptions &suite = arguments.suite;
  const WayRow &way = *arguments.way;
  suite.subject = way.subject;
  if (arguments.wild && way.subject == arbSubject)
    suite.subject = wildSubject;
  if (arguments.unwritten)
    suite.subject = way.unwritten;
  if (arguments.plain)
    suite.subject = [given = suite.subject](std::uint64_t seed) {
      return plainSubject(given(seed));
    };
  if (arguments.programs.empty())
    return !arguments.unwritten || way.unwritten;
  const auto language =
      way.random == runVertexSuite ? fp::ir::Language::ArbVertex : fp::ir::Language::ArbFragment;
  suite.firstSeed = 1;
  suite.count = int(arguments.programs.size());
  suite.subject = [&programs = arguments.programs, language](std::uint64_t seed) {
    return subjectOf(language, programs[seed - 1]);
  };
  return arguments.language != "ati" && !arguments.edges && !suite.mutate;
}

bool parse(int argc, char **argv, Arguments &arguments) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (i + 1 == argc)
      return false;
    const char *value = argv[++i];
    if (name == "--mode")
      arguments.mode = value;
    else if (name == "--language")
      arguments.language = value;
    else if (name == "--count" && std::atoi(value) > 0)
      arguments.suite.count = std::atoi(value);
    else if (name == "--seed")
      arguments.suite.firstSeed = std::strtoull(value, nullptr, 10);
    else if (name == "--suite" && isSuite(value)) {
      arguments.edges = !std::strcmp(value, "edges");
      arguments.suite.mutate = !std::strcmp(value, "mutants");
    } else if (name == "--numerics" && fp::numericsNamed(value))
      arguments.suite.numerics = *fp::numericsNamed(value);
    else if (name == "--wild")
      arguments.wild = !std::strcmp(value, "1");
    else if (name == "--unwritten")
      arguments.unwritten = !std::strcmp(value, "1");
    else if (name == "--plain")
      arguments.plain = !std::strcmp(value, "1");
    else if (name == "--program") {
      if (!readProgram(value, arguments))
        return false;
    } else if (name == "--json")
      arguments.json = value;
    else if (name == "--failures")
      arguments.suite.failures = value;
    else
      return false;
  }
  arguments.way = findWay(arguments.language, arguments.mode);
  if (!arguments.way)
    return false;
  return (arguments.way->edges || !arguments.edges) && chooseSubjects(arguments);
}

void writeJson(const std::string &path, const std::string &mode, fp::Numerics numerics,
               const Report &report) {
  arbiter::JsonWriter json;
  json.beginObject().key("schema").value(1).key("mode").value(mode);
  json.key("numerics").value(fp::kNumericsNames[std::size_t(numerics)]);
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
  if (const std::string fault = numericsFault(arguments); !fault.empty()) {
    std::fprintf(stderr, "differential: %s\n", fault.c_str());
    return 2;
  }
  std::string why;
  const auto host = GlHost::create(why);
  if (!host) {
    std::fprintf(stderr, "differential: no GL context: %s\n", why.c_str());
    return 77;
  }
  const auto backend = arguments.way->create(arguments.suite.numerics);
  const auto run = arguments.edges ? arguments.way->edges : arguments.way->random;
  const Report report = run(*backend, arguments.suite);
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
    writeJson(arguments.json, arguments.mode, arguments.suite.numerics, report);
  return report.failures.empty() ? 0 : 1;
}
