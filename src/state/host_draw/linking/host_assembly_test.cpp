// Checks vertex programs that are the host's own: their text, the enables, and the parameters sent.
#include "state/host_draw/linking/host_assembly.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "state/lifecycle/lifecycle.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr char kAddingText[] = "!!ARBvp1.0\n"
                               "ADD result.position, vertex.position, program.env[3];\n"
                               "MOV result.color, program.local[1];\n"
                               "END\n";
constexpr char kColorText[] = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n";

using Calls = std::vector<std::string>;

const std::string kVertexName = std::to_string(kVertex);

/// Returns the calls that sent a parameter.
Calls sent(const FakeHost &host) {
  Calls calls;
  for (const std::string &call : host.calls)
    if (call.find("Parameter4fv") != std::string::npos ||
        call.find("Parameters4fv") != std::string::npos)
      calls.push_back(call);
  return calls;
}

TEST(HostAssembly, AVertexProgramIsTheHostsBesideAnyFragments) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kAddingText, kVertex);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]);
  EXPECT_EQ(host.currentProgram, 0u);
  EXPECT_EQ(drawsBy(*context, Path::HostAssembly), 1u);
  use(*context, kColorText);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]);
  EXPECT_FALSE(host.targets[kFragment]);
  EXPECT_NE(host.currentProgram, 0u) << "fragments are GLSL";
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
  handlers::Disable(*context, kVertex);
  ASSERT_TRUE(draw(*context));
  EXPECT_FALSE(host.targets[kVertex]);
}

TEST(HostAssembly, AFragmentProgramIsLinkedOnceForAllItsPairs) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kColorText);
  for (int i = 0; i < 5; ++i) {
    use(*context, std::string(kAddingText) + std::string(std::size_t(i), ' '), kVertex);
    ASSERT_TRUE(draw(*context));
  }
  EXPECT_EQ(host.count("LinkProgram"), 1);
  EXPECT_EQ(host.programs.size(), 1u);
  EXPECT_EQ(host.assembly.size(), 5u);
}

TEST(HostAssembly, WhatTheFragmentProgramReadsAndNothingWritesIsDefined) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kAddingText, kVertex);
  use(*context, kColorText);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.assembly.size(), 1u);
  use(*context, "!!ARBfp1.0\nMUL result.color, fragment.texcoord[5], fragment.fogcoord.x;\nEND\n");
  ASSERT_TRUE(draw(*context));
  ASSERT_EQ(host.assembly.size(), 2u) << "a text of its own for that pair";
  const std::string &text = host.assembly.rbegin()->second;
  EXPECT_NE(text.find("MOV result.texcoord[5], p2;"), std::string::npos) << text;
  EXPECT_NE(text.find("MOV result.fogcoord.x, p2;"), std::string::npos) << text;
  EXPECT_NE(text.find("PARAM p2 = {0, 0, 0, 1};"), std::string::npos) << text;
  EXPECT_EQ(text.find("MOV result.texcoord[4]"), std::string::npos) << text;
}

// NVIDIA's driver gives (0, 0, 0, 1) for components that are never written, and osgFX's cartoons
// divide by that w.
TEST(HostAssembly, ComponentsThatNothingWritesAreTheHosts) {
  FakeHost host;
  const CurrentContext context(host);
  for (const bool onProcessor : {false, true}) {
    context->caps.onProcessor = onProcessor;
    use(*context,
        "!!ARBvp1.0\n#" + std::to_string(onProcessor) +
            "\nMOV result.position, vertex.position;\nMOV result.texcoord[0].x, "
            "vertex.color;\nEND\n",
        kVertex);
    ASSERT_TRUE(draw(*context));
    const std::string &text = host.assembly.rbegin()->second;
    EXPECT_EQ(text.find("MOV result.texcoord[0].yzw, {0, 0, 0, 0};") != std::string::npos,
              onProcessor)
        << text;
  }
}

TEST(HostAssembly, ParametersGoAsFarAsTheyChanged) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kAddingText, kVertex);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 3, 7, 0, 0, 0);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 4, 8, 0, 0, 0); // not read
  handlers::ProgramLocalParameter4fARB(*context, kVertex, 1, 9, 0, 0, 0);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(sent(host), (Calls{"ProgramEnvParameter4fv " + kVertexName + " 3 7",
                               "ProgramLocalParameter4fv " + kVertexName + " 1 9"}));
  host.calls.clear();
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 3, 7, 0, 0, 0);
  handlers::ProgramLocalParameter4fARB(*context, kVertex, 1, 5, 0, 0, 0);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(sent(host), (Calls{"ProgramLocalParameter4fv " + kVertexName + " 1 5"}));
  EXPECT_EQ(host.calls.size(), 1u) << "nothing else is asked";
}

// For a palette of matrices, consecutive changed parameters go in one call if the host can take
// several.
TEST(HostAssembly, ConsecutiveParametersGoTogether) {
  constexpr char kPalette[] = "!!ARBvp1.0\n"
                              "PARAM m[4] = {program.env[8..11]};\nADDRESS a;\nTEMP p;\n"
                              "ARL a.x, vertex.attrib[1].x;\n"
                              "ADD p, m[a.x], program.local[5];\nADD p, p, program.local[6];\n"
                              "ADD result.position, p, program.local[2];\nEND\n";
  for (const bool offered : {true, false}) {
    FakeHost host;
    if (offered)
      host.extensions.push_back("GL_EXT_gpu_program_parameters");
    const CurrentContext context(host);
    use(*context, kPalette, kVertex);
    ASSERT_TRUE(draw(*context));
    const auto env = [&](GLuint index, GLfloat x) {
      handlers::ProgramEnvParameter4fARB(*context, kVertex, index, x, 0, 0, 0);
    };
    const auto local = [&](GLuint index, GLfloat x) {
      handlers::ProgramLocalParameter4fARB(*context, kVertex, index, x, 0, 0, 0);
    };
    for (GLuint i = 8; i < 12; ++i)
      env(i, GLfloat(i));
    for (const GLuint i : {5u, 6u, 2u})
      local(i, GLfloat(i));
    host.calls.clear();
    ASSERT_TRUE(draw(*context));
    Calls calls = sent(host);
    std::sort(calls.begin(), calls.end());
    const std::string e = "ProgramEnvParameter4fv " + kVertexName,
                      l = "ProgramLocalParameter4fv " + kVertexName,
                      ee = "ProgramEnvParameters4fv " + kVertexName,
                      ll = "ProgramLocalParameters4fv " + kVertexName;
    EXPECT_EQ(calls, (offered ? Calls{ee + " 8 8 9 10 11", l + " 2 2", ll + " 5 5 6"}
                              : Calls{e + " 10 10", e + " 11 11", e + " 8 8", e + " 9 9",
                                      l + " 2 2", l + " 5 5", l + " 6 6"}));
    // Changed parameters in the middle are sent alone, with their neighbours.
    env(9, 1);
    env(10, 2);
    host.calls.clear();
    ASSERT_TRUE(draw(*context));
    EXPECT_EQ(sent(host), (offered ? Calls{ee + " 9 1 2"} : Calls{e + " 9 1", e + " 10 2"}));
  }
}

// Env parameters belong to the target, so another program's draw may have changed the host's
// values.
TEST(HostAssembly, EnvValuesAreTheTargets) {
  FakeHost host;
  const CurrentContext context(host);
  const GLuint first = use(*context, kAddingText, kVertex);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 3, 1, 0, 0, 0);
  ASSERT_TRUE(draw(*context));
  use(*context, std::string(kAddingText) + " ", kVertex);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 3, 2, 0, 0, 0);
  ASSERT_TRUE(draw(*context));
  handlers::BindProgramARB(*context, kVertex, first);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 3, 1, 0, 0, 0);
  host.calls.clear();
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(sent(host), (Calls{"ProgramEnvParameter4fv " + kVertexName + " 3 1"}));
}

// The layer's own enable must be neither saved nor restored for the application.
TEST(HostAssembly, AttributeStacksBringBackNoEnable) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kAddingText, kVertex);
  ASSERT_TRUE(draw(*context));
  handlers::PushAttrib(*context, GL_ALL_ATTRIB_BITS);
  handlers::Disable(*context, kVertex);
  ASSERT_TRUE(draw(*context));
  handlers::PushAttrib(*context, GL_LIGHTING_BIT);
  handlers::PopAttrib(*context);
  EXPECT_FALSE(host.targets[kVertex]);
  handlers::PopAttrib(*context);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]) << "the application enabled it before the push";

  handlers::Disable(*context, kVertex);
  ASSERT_TRUE(draw(*context));
  // the fake host saves the enables all the same
  handlers::PushAttrib(*context, GL_COLOR_BUFFER_BIT);
  handlers::Enable(*context, kVertex);
  ASSERT_TRUE(draw(*context));
  handlers::PopAttrib(*context);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]) << "a pop without enables takes none away";
}

// A list compiled before the first program is the host's alone, so its PopAttrib is not noticed
// directly.
TEST(HostAssembly, AHostsListThatPopsBringsNoEnable) {
  FakeHost host;
  const CurrentContext context(host);
  host.lists.insert(7); // compiled before
  use(*context, kAddingText, kVertex);
  ASSERT_TRUE(draw(*context));
  handlers::Disable(*context, kVertex);
  ASSERT_TRUE(draw(*context));
  host.targets[kVertex] = true; // the list's PopAttrib does this
  handlers::CallList(*context, 7);
  EXPECT_FALSE(host.targets[kVertex]);
}

TEST(HostAssembly, NoListRecordsAnEnable) {
  FakeHost host;
  const CurrentContext context(host);
  host.lists.insert(7);
  use(*context, kAddingText, kVertex);
  ASSERT_TRUE(draw(*context));
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    handlers::NewList(*context, 8, mode);
    handlers::CallList(*context, 7);
    handlers::Disable(*context, kVertex);
    handlers::Enable(*context, kVertex);
    handlers::EndList(*context);
  }
  handlers::CallList(*context, 8);
  for (const std::string &call : host.recorded)
    EXPECT_EQ(call.find("able " + kVertexName), std::string::npos) << call;
}

TEST(HostAssembly, CopyContextBringsNoEnable) {
  FakeHost host;
  const CurrentContext from(host);
  const CurrentContext to(host);
  host.targets[kVertex] = true; // CopyContext of a context that draws with it leaves this
  copyContext(*from, *to, GL_ALL_ATTRIB_BITS);
  ASSERT_TRUE(draw(*to));
  EXPECT_FALSE(host.targets[kVertex]);
}

TEST(HostAssembly, AProgramThatIsDeletedLeavesNothing) {
  FakeHost host;
  const CurrentContext context(host);
  const GLuint name = use(*context, kAddingText, kVertex);
  use(*context, kColorText);
  ASSERT_TRUE(draw(*context));
  handlers::DeleteProgramsARB(*context, 1, &name);
  EXPECT_TRUE(host.assembly.empty());
  EXPECT_FALSE(host.targets[kVertex]);
  handlers::Disable(*context, kVertex);
  ASSERT_TRUE(draw(*context)) << "the fragment program's own GLSL stays";
  EXPECT_EQ(host.count("LinkProgram"), 1);
}

TEST(HostAssembly, ProgramsThatAreReplacedDoNotPileUp) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kAddingText, kVertex);
  for (int i = 0; i < 200; ++i) {
    load(*context, std::string(kAddingText) + std::to_string(i), kVertex);
    handlers::GetError(*context);
    load(*context, "!!ARBvp1.0\n#" + std::to_string(i) + "\nMOV result.position, {1};\nEND",
         kVertex);
    ASSERT_TRUE(draw(*context));
  }
  EXPECT_LE(host.assembly.size(), 2u);
}

TEST(HostAssembly, WhatTheHostRefusesIsGlsl) {
  FakeHost host;
  host.refusesAssembly = true;
  const CurrentContext context(host);
  use(*context, kAddingText, kVertex);
  use(*context, kColorText);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("CreateShader"), 2);
  EXPECT_FALSE(host.targets[kVertex]);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_NO_ERROR));
}

/// Uses NVIDIA's option: a loop of two iterations that adds two rows.
constexpr char kCounted[] = "!!ARBvp1.0\nOPTION NV_vertex_program2;\nTEMP r, k;\nADDRESS a;\n"
                            "PARAM c[4] = { program.env[0..3] };\nMOV k.x, 1.0;\nagain:\n"
                            "ARL a.x, k.x;\nADD r, r, c[a.x + 2];\nADDC k.x, k.x, -1.0;\n"
                            "BRA again (GE.x);\nMOV result.position, vertex.position;\n"
                            "MOV result.color, r;\nEND\n";

TEST(HostAssembly, AProgramOfNvidiasIsOneOfTheArbWhereItsCodeIs) {
  FakeHost host;
  const CurrentContext context(host);
  context->row(Target::Vertex).limits.nvOptions = 2;
  use(*context, kCounted, kVertex);
  use(*context, kColorText);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]);
  ASSERT_EQ(host.assembly.size(), 1u);
  const std::string text = host.assembly.begin()->second;
  EXPECT_NE(text.find("program.env[3]"), std::string::npos) << text;
  EXPECT_EQ(text.find("program.env[1]"), std::string::npos) << text;
  EXPECT_EQ(text.find("ARL"), std::string::npos) << text;
  EXPECT_EQ(host.count("CreateShader"), 1) << "of the fragments";
  use(*context,
      "!!ARBvp1.0\nOPTION NV_vertex_program2;\nTEMP r;\nMOV result.position, vertex.position;\n"
      "MOVC r, vertex.color;\nMOV r (LT.x), 0.5;\nMOV result.color, r;\nEND\n",
      kVertex);
  ASSERT_TRUE(draw(*context));
  EXPECT_FALSE(host.targets[kVertex]) << "no text of the ARB's chooses";
  EXPECT_EQ(host.assembly.size(), 1u);
}

TEST(HostAssembly, RowsByAddressOfNvidiasHaveZerosBesideThem) {
  FakeHost host;
  const CurrentContext context(host);
  context->row(Target::Vertex).limits.nvOptions = 2;
  const std::string text =
      "!!ARBvp1.0\nOPTION NV_vertex_program2;\nADDRESS a;\n"
      "PARAM c[4] = { program.env[0..3] };\nARL a.x, vertex.color.x;\n"
      "MOV result.position, vertex.position;\nMOV result.color, c[a.x];\nEND\n";
  use(*context, text.c_str(), kVertex);
  use(*context, kColorText);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]);
  ASSERT_EQ(host.assembly.size(), 1u);
  EXPECT_NE(host.assembly.begin()->second.find("c0[6] = { {0, 0, 0, 0}, program.env[0..3]"),
            std::string::npos)
      << host.assembly.begin()->second;
  EXPECT_EQ(host.count("CreateShader"), 1) << "of the fragments";
}

/// Returns the number of instructions in a text, and of the temporaries that it declares.
std::pair<GLint, GLint> sizeOf(const std::string &text) {
  std::istringstream lines(text);
  GLint instructions = 0, temporaries = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("TEMP") == 0)
      temporaries = GLint(std::count(line.begin(), line.end(), ',')) + 1;
    else if (line.find("PARAM") != 0 && line.find(',') != std::string::npos)
      ++instructions;
  }
  return {instructions, temporaries};
}

TEST(HostAssembly, ATextOfNvidiasThatIsTooMuchForTheHostIsGlsl) {
  const std::string text = "!!ARBvp1.0\nOPTION NV_vertex_program2;\nADDRESS a;\nTEMP r;\n"
                           "PARAM c[4] = { program.env[0..3] };\nARL a.x, vertex.color.x;\n"
                           "MOV r, c[a.x];\nADD r, r, c[a.x + 1];\n"
                           "MOV result.position, vertex.position;\nMOV result.color, r;\nEND\n";
  struct Outcome {
    std::string assembly; ///< empty if no assembly was given to the host
    int shaders = 0;
  };
  const auto under = [&](GLenum limit, GLint most) {
    FakeHost host;
    const CurrentContext context(host);
    context->row(Target::Vertex).limits.nvOptions = 2;
    host.programLimits[limit] = most;
    use(*context, text, kVertex);
    use(*context, kColorText);
    EXPECT_TRUE(draw(*context));
    EXPECT_EQ(handlers::GetError(*context), GLenum(GL_NO_ERROR));
    EXPECT_EQ(host.targets[kVertex], !host.assembly.empty());
    return Outcome{host.assembly.empty() ? "" : host.assembly.begin()->second,
                   host.count("CreateShader")};
  };
  const std::string whole = under(GL_MAX_PROGRAM_TEMPORARIES_ARB, 64).assembly;
  const auto [instructions, temporaries] = sizeOf(whole);
  ASSERT_GT(temporaries, 1) << whole;
  for (const auto &[limit, enough] : std::vector<std::pair<GLenum, GLint>>{
           {GL_MAX_PROGRAM_TEMPORARIES_ARB, temporaries},
           {GL_MAX_PROGRAM_NATIVE_TEMPORARIES_ARB, temporaries},
           {GL_MAX_PROGRAM_INSTRUCTIONS_ARB, instructions},
           {GL_MAX_PROGRAM_NATIVE_INSTRUCTIONS_ARB, instructions}}) {
    EXPECT_EQ(under(limit, enough).assembly, whole) << limit;
    EXPECT_EQ(under(limit, enough).shaders, 1) << limit << ": of the fragments";
    EXPECT_EQ(under(limit, enough - 1).assembly, "") << limit;
    EXPECT_EQ(under(limit, enough - 1).shaders, 2) << limit;
  }
  EXPECT_EQ(under(GL_MAX_PROGRAM_NATIVE_TEMPORARIES_ARB, 0).assembly, whole)
      << "as hosts say that have no such limit";
  EXPECT_EQ(under(GL_MAX_PROGRAM_NATIVE_PARAMETERS_ARB, 6).assembly, "");
}

TEST(HostAssembly, ClipPlanesClipNoProgramOfNvidias) {
  FakeHost host;
  const CurrentContext context(host);
  context->row(Target::Vertex).limits.nvOptions = 2;
  use(*context, kCounted, kVertex);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]);
  host.enabled = {GL_CLIP_PLANE0};
  handlers::Enable(*context, GL_CLIP_PLANE0);
  ASSERT_TRUE(draw(*context));
  EXPECT_FALSE(host.targets[kVertex]) << "the host would clip what its assembly gives";
  EXPECT_NE(host.currentProgram, 0u);
  host.enabled = {};
  handlers::Disable(*context, GL_CLIP_PLANE0);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]);
  use(*context, kAddingText, kVertex);
  host.enabled = {GL_CLIP_PLANE0};
  handlers::Enable(*context, GL_CLIP_PLANE0);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.targets[kVertex]) << "one of the ARB's is";
}

} // namespace
} // namespace arbiter::state
