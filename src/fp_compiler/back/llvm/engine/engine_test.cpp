// Tests of the engine as the layer uses it: the library opened at run time, the cache, threads,
// lifetimes.

#include <cfenv>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/mman.h>
#include <thread>
#include <utility>

#include <llvm/Config/llvm-config.h>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/jit.h"
#include "util/cache/cache_store.h"

namespace arbiter::fp::jit {
namespace {

using ir::Opcode;

/// Returns a program that writes texcoord[0]: attribute 1 times a row plus `offset`.
ir::Program scaled(float offset) {
  ir::Builder b(ir::Language::ArbVertex);
  b.op(Opcode::Mad, b.result(ir::OutputKind::TexCoord),
       {b.attribute(ir::AttributeKind::Generic, 1), b.local(0), b.constant(offset)});
  return b.take();
}

std::unique_ptr<Engine> engineFor(const EngineOptions &options) {
  std::string reason;
  auto engine = makeEngine(options, reason);
  EXPECT_NE(engine, nullptr) << reason;
  return engine;
}

std::unique_ptr<VertexCode> compiled(Engine &engine, const ir::Program &program) {
  const auto prepared = engine.prepareVertex(program, Numerics::Host);
  EXPECT_NE(prepared, nullptr);
  std::string reason;
  auto code = prepared ? engine.compile(*prepared, abi::VertexKey{}, reason) : nullptr;
  EXPECT_NE(code, nullptr) << reason;
  return code;
}

/// Runs the code of scaled() on `count` vertices with x, y, z, w = i, 1, 2, 3 times 2.
std::vector<float> run(const VertexCode &code, std::uint32_t count) {
  constexpr std::size_t kRoom = 64;
  alignas(64) static thread_local float in[4][kRoom], out[4][kRoom], position[4][kRoom];
  for (std::size_t i = 0; i < kRoom; ++i) {
    in[0][i] = float(i);
    for (std::size_t c = 1; c < 4; ++c)
      in[c][i] = float(c);
    for (auto &array : out)
      array[i] = -1;
  }
  const float parameters[2][4] = {{2, 2, 2, 2}, {}};
  const float *const inputs[] = {in[0], in[1], in[2], in[3]};
  // The position is a result even though the program does not write it.
  float *const outputs[] = {out[0],      out[1],      out[2],      out[3],
                            position[0], position[1], position[2], position[3]};
  abi::VertexData data;
  data.parameters = parameters;
  data.inputs = inputs;
  data.outputs = outputs;
  code.function(&data, count);
  return {out[0], out[0] + kRoom};
}

TEST(Engine, SaysWhatItIs) {
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  EXPECT_TRUE(engine->lanes() == 4 || engine->lanes() == 8 || engine->lanes() == 16);
  EXPECT_EQ(engine->blockWidth() * engine->blockHeight(), engine->lanes());
  EXPECT_NE(engine->target().find("lanes"), std::string::npos);
  std::string reason;
  EXPECT_EQ(makeEngine({"a processor of no name"}, reason), nullptr);
  EXPECT_NE(reason, "");
}

TEST(Engine, RunsVertices) {
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  const auto code = compiled(*engine, scaled(10));
  ASSERT_NE(code, nullptr);
  EXPECT_GT(code->bytes, 0u);
  const std::uint32_t lanes = std::uint32_t(engine->lanes());
  for (const std::uint32_t count : {0u, 1u, 5u, lanes, lanes + 1, 48u}) {
    const std::vector<float> x = run(*code, count);
    for (std::uint32_t i = 0; i < count; ++i)
      EXPECT_EQ(x[i], 2.0f * float(i) + 10) << i << " of " << count;
    // The last vector may be written in full, but nothing beyond it.
    EXPECT_EQ(x[(count + lanes - 1) / lanes * lanes], -1.0f) << count;
  }
}

TEST(Engine, RefusesWhatItHasNoCodeFor) {
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  const ir::Program vertex = scaled(1);
  EXPECT_EQ(engine->prepareFragment(vertex, Numerics::Host), nullptr);
  ir::Builder b;
  b.op(Opcode::Mov, b.color(), {b.attribute(ir::AttributeKind::ColorPrimary)});
  EXPECT_EQ(engine->prepareVertex(b.program(), Numerics::Host), nullptr);
  EXPECT_EQ(engine->prepareFragment(b.program(), Numerics::Fp24), nullptr);
  ir::Program broken = b.program();
  broken.code[0].src[0].index = 99;
  EXPECT_EQ(engine->prepareFragment(broken, Numerics::Host), nullptr);
}

TEST(Engine, RefusesAKeyOfAnotherMode) {
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  ir::Builder b;
  b.op(Opcode::Mov, b.color(), {b.attribute(ir::AttributeKind::ColorPrimary)});
  const auto prepared = engine->prepareFragment(b.program(), Numerics::Legacy);
  ASSERT_NE(prepared, nullptr);
  abi::FragmentKey key{};
  std::string reason;
  EXPECT_EQ(engine->compile(*prepared, key, reason), nullptr);
  EXPECT_NE(reason, "");
  key.numerics = std::uint8_t(Numerics::Legacy);
  EXPECT_NE(engine->compile(*prepared, key, reason), nullptr);
}

TEST(Engine, CodeOutlivesTheEngine) {
  auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  const auto code = compiled(*engine, scaled(3));
  engine.reset();
  ASSERT_NE(code, nullptr);
  EXPECT_EQ(run(*code, 2)[1], 5.0f);
}

TEST(Engine, ComputesInItsOwnModeAndLeavesTheCallers) {
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  const auto code = compiled(*engine, scaled(0x1p-24f));
  ASSERT_NE(code, nullptr);
  std::fesetround(FE_UPWARD);
  const std::vector<float> x = run(*code, 2);
  const int mode = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(mode, FE_UPWARD);
  EXPECT_EQ(x[1], 2.0f); // 2 + 2^-24 to nearest; upward it would be 2 + 2^-22
}

TEST(Engine, CompilesOnSeveralThreads) {
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  std::vector<std::thread> threads;
  std::array<int, 4> right = {};
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 8; ++i) {
        const float offset = float(16 * t + i);
        const auto code = compiled(*engine, scaled(offset));
        right[std::size_t(t)] += code && run(*code, 3)[2] == 4 + offset;
      }
    });
  for (std::thread &thread : threads)
    thread.join();
  EXPECT_EQ(right, (std::array<int, 4>{8, 8, 8, 8}));
}

/// Fills the address space so that two new pages are 8 GiB apart: only one page above the reserved
/// range is free.
class Scattered {
public:
  Scattered() {
    auto *const reserved = static_cast<std::uint8_t *>(map(kReserved));
    for (std::size_t bytes = std::size_t(1) << 30; bytes >= kPage; bytes /= 8)
      while (m_mappings.size() < kMax && map(bytes) > reserved) {
      }
    munmap(reserved + kReserved - kPage, kPage);
  }
  ~Scattered() {
    for (const auto &[begin, bytes] : m_mappings)
      munmap(begin, bytes);
  }
  Scattered(const Scattered &) = delete;
  Scattered &operator=(const Scattered &) = delete;

private:
  static constexpr std::size_t kReserved = std::size_t(8ull << 30), kPage = 4096;
  static constexpr std::size_t kMax = 4000; ///< in case addresses are assigned upwards

  void *map(std::size_t bytes) {
    void *const begin =
        mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin == MAP_FAILED)
      return nullptr;
    m_mappings.emplace_back(begin, bytes);
    return begin;
  }
  std::vector<std::pair<void *, std::size_t>> m_mappings;
};

TEST(Engine, CodeLiesBesideItsConstants) {
  if (sizeof(void *) == 4)
    GTEST_SKIP() << "32 bits: no two addresses are too far apart";
  const auto engine = engineFor({});
  ASSERT_NE(engine, nullptr);
  const auto before = compiled(*engine, scaled(1)); // first maps what LLVM itself maps once
  const Scattered scattered;
  const auto code = compiled(*engine, scaled(12));
  ASSERT_NE(code, nullptr);
  EXPECT_EQ(run(*code, 3)[2], 16.0f);
}

class EngineCache : public ::testing::Test {
protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "arbiter-jit-XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    m_folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(m_folder); }

  std::string m_folder;
};

TEST_F(EngineCache, GivesBackWhatWasMade) {
  for (int round = 0; round < 2; ++round) {
    const auto engine = engineFor({"", m_folder + "/objects", 1 << 24});
    ASSERT_NE(engine, nullptr);
    const auto one = compiled(*engine, scaled(1)), two = compiled(*engine, scaled(2));
    ASSERT_TRUE(one && two);
    EXPECT_EQ(run(*one, 2)[1], 3.0f);
    EXPECT_EQ(run(*two, 2)[1], 4.0f);
    // The second round used the entries of the first, and added nothing.
    EXPECT_EQ(cacheUsage(m_folder + "/objects").files, 2u);
  }
}

// Object code is executed. An entry that differs in any byte from what was stored must be compiled
// again.
TEST_F(EngineCache, MakesAnewWhatIsDamaged) {
  namespace fs = std::filesystem;
  const auto engine = engineFor({"", m_folder + "/objects", 1 << 24});
  ASSERT_NE(engine, nullptr);
  ASSERT_NE(compiled(*engine, scaled(1)), nullptr);
  std::vector<fs::path> entries;
  for (const auto &entry : fs::recursive_directory_iterator(m_folder + "/objects"))
    if (entry.is_regular_file() && entry.path().filename() != "key")
      entries.push_back(entry.path());
  ASSERT_EQ(entries.size(), 1u);
  const auto bytesOf = [](const fs::path &path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  };
  const std::string good = bytesOf(entries[0]);
  const auto meets = [&](const std::string &bad, std::size_t at) {
    std::ofstream(entries[0], std::ios::binary) << bad; // keeps the file's access rights
    const auto code = compiled(*engine, scaled(1));
    ASSERT_NE(code, nullptr) << at;
    EXPECT_EQ(run(*code, 2)[1], 3.0f) << at;
    EXPECT_EQ(bytesOf(entries[0]), good) << at; // stored again
  };
  constexpr std::size_t kPlaces = 48;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const std::size_t at = (good.size() - 1) * i / (kPlaces - 1);
    std::string bad = good;
    bad[at] = char(bad[at] ^ (1 << (i % 8)));
    meets(bad, at);
    if (i % 4 == 0)
      meets(good.substr(0, at), at);
  }
}

// The cache key must contain the LLVM version, whether LLVM is linked into the library or mapped
// separately.
TEST_F(EngineCache, KeepsVersionsOfLlvmApart) {
  const auto engine = engineFor({"", m_folder + "/objects", 1 << 24});
  ASSERT_NE(engine, nullptr);
  ASSERT_NE(compiled(*engine, scaled(1)), nullptr);
  int entries = 0;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(m_folder + "/objects")) {
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    entries += text.str().find(" LLVM " LLVM_VERSION_STRING " ") != std::string::npos;
  }
  EXPECT_EQ(entries, 1);
}

TEST_F(EngineCache, KeepsProcessorsApart) {
  std::string reason;
  std::uint64_t files = 0;
  for (const char *const cpu : {"", "avx512", "avx2", "sse4.1", "neon"})
    if (const auto engine = makeEngine({cpu, m_folder + "/objects", 1 << 24}, reason)) {
      const auto code = compiled(*engine, scaled(1));
      ASSERT_NE(code, nullptr);
      EXPECT_EQ(run(*code, 2)[1], 3.0f) << cpu;
      EXPECT_EQ(cacheUsage(m_folder + "/objects").files, ++files) << cpu;
    }
  EXPECT_GE(files, 2u);
}

} // namespace
} // namespace arbiter::fp::jit
