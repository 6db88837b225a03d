// Tests that the cost of a program's machine code is estimated before it is generated.
#include "fp_compiler/back/llvm/engine/budget.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/compiler.h"

namespace arbiter::fp::llvm_back {
namespace {

ir::Program checked(const std::string &text) {
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  options.limits.textureCoords = 8;
  options.limits.textureImageUnits = 16;
  options.limits.textureUnits = 8;
  options.limits.drawBuffers = 4;
  options.limits.envParameters = options.limits.localParameters = 64;
  options.limits.programMatrices = 8;
  CheckResult result = checkFragmentProgram(text, options);
  EXPECT_TRUE(result.ok()) << result.errorString(text).substr(0, 400);
  return result.ok() ? std::move(*result.program) : ir::Program();
}

/// Returns a chain of `count` instructions, each of which depends on the one before.
ir::Program chainOf(const char *instruction, int count) {
  std::string text =
      "!!ARBfp1.0\nTEMP t, u;\nMOV t, fragment.texcoord[0];\nMOV u, fragment.color;\n";
  for (int i = 0; i < count; ++i)
    text += instruction;
  return checked(text + "ADD result.color, t, u;\nEND\n");
}

/// Returns a key with the most expensive samplers.
abi::FragmentKey dearKey() {
  abi::FragmentKey key;
  key.lanes = abi::Lanes::Quad;
  const abi::Format rgba8 = {abi::Layout::U8x4,
                             {abi::From::C0, abi::From::C1, abi::From::C2, abi::From::C3}};
  key.targets[0].format = rgba8;
  for (abi::SamplerKey &sampler : key.samplers) {
    sampler.format = rgba8;
    sampler.magnify = sampler.minify = abi::Filter::Linear;
    sampler.mip = abi::MipFilter::Linear;
  }
  return key;
}

TEST(Budget, LongProgramsAreRefusedAtOnce) {
  const auto engine = makeEngine({});
  ASSERT_NE(engine, nullptr);
  for (const char *const each :
       {"MAD t, t, u, u.yzwx;\n", "TEX t, t, texture[0], 2D;\n", "POW t.x, u.y, t.x;\n"}) {
    const ir::Program program = chainOf(each, 16000);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(engine->prepareFragment(program, Numerics::Host), nullptr) << each;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(time.count(), 0.6) << each;
  }
}

TEST(Budget, SoAreThoseThatLlvmAloneWouldTakeLongFor) {
  const auto engine = makeEngine({});
  ASSERT_NE(engine, nullptr);
  const abi::FragmentKey key = dearKey();
  for (const auto &[each, count] :
       {std::pair("MAD t, t, u, u.yzwx;\n", 1000), std::pair("TEX t, t, texture[0], 2D;\n", 100)}) {
    const auto prepared = engine->prepareFragment(chainOf(each, count), Numerics::Host);
    ASSERT_NE(prepared, nullptr) << each;
    std::string reason;
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(engine->compile(*prepared, key, reason), nullptr) << each;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(time.count(), 0.1) << each;
    EXPECT_NE(reason.find("ms to compile"), std::string::npos) << reason;
  }
}

TEST(Budget, WhatARadeonTakesIsWithinIt) {
  abi::FragmentKey key = dearKey();
  for (abi::SamplerKey &sampler : key.samplers)
    sampler.dimension = abi::Dimension::Cube;
  // This has 64 ALU instructions and 32 samples, all of them trilinear and of cube maps.
  std::string text =
      "!!ARBfp1.0\nTEMP t, u;\nMOV t, fragment.texcoord[0];\nMOV u, fragment.color;\n";
  for (int i = 0; i < 32; ++i)
    text += "TEX t, t, texture[0], CUBE;\nMAD u, t, u, u.yzwx;\nLRP t, t, u, u.yzwx;\n";
  EXPECT_LE(expectedMilliseconds(checked(text + "ADD result.color, t, u;\nEND\n"), &key.samplers),
            kMaxMilliseconds);
  // The following took less than 300 ms on a busy processor.
  EXPECT_LE(expectedMilliseconds(chainOf("POW t.x, u.y, t.x;\n", 100), &key.samplers),
            kMaxMilliseconds);
  EXPECT_LE(expectedMilliseconds(chainOf("SIN t.x, t.x;\nADD t, t, u;\n", 100), &key.samplers),
            kMaxMilliseconds);
  EXPECT_LE(expectedMilliseconds(chainOf("RSQ t.x, t.x;\nADD t, t, u;\n", 200), &key.samplers),
            kMaxMilliseconds);
  EXPECT_LE(expectedMilliseconds(chainOf("MAD t, t, u, u.yzwx;\n", 400), &key.samplers),
            kMaxMilliseconds);
  EXPECT_LE(expectedMilliseconds(chainOf("MAD t, t, u, u.yzwx;\n", 256), nullptr),
            kMaxMilliseconds);
}

TEST(Budget, SoIsEveryGoldenProgram) {
  const abi::FragmentKey key = dearKey();
  int programs = 0;
  for (const auto &entry : std::filesystem::directory_iterator(GOLDEN_PROGRAMS)) {
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    if (entry.path().extension() != ".fp" || text.str().rfind("!!ARBfp1.0", 0) != 0)
      continue;
    EXPECT_LE(expectedMilliseconds(checked(text.str()), &key.samplers), kMaxMilliseconds)
        << entry.path();
    ++programs;
  }
  EXPECT_GT(programs, 10);
}

} // namespace
} // namespace arbiter::fp::llvm_back
