#include "fp_compiler/back/llvm/engine/reserve.h"

#include <cstdint>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace arbiter::fp::llvm_back {
namespace {

struct Block {
  unsigned char *at;
  std::size_t bytes;
  unsigned char fill;
};

bool isWhole(const Block &block) {
  for (std::size_t i = 0; i < block.bytes; ++i)
    if (block.at[i] != block.fill)
      return false;
  return true;
}

/// Makes random allocations and releases. Each block is filled with a number of its own.
void work(unsigned seed, bool &right) {
  std::mt19937 random(seed);
  std::vector<Block> blocks;
  for (int i = 0; i < 4000; ++i) {
    if (random() % 5 < 3) {
      const std::size_t bytes = random() % (random() % 8 == 0 ? 20000 : 200);
      const std::size_t alignment = std::size_t(1) << random() % 10;
      auto *const at = static_cast<unsigned char *>(reserve::allocate(bytes, alignment));
      if (!at)
        continue;
      right = right && reinterpret_cast<std::uintptr_t>(at) % alignment == 0 && reserve::has(at) &&
              reserve::sizeOf(at) >= bytes;
      blocks.push_back({at, bytes, static_cast<unsigned char>(random())});
      std::memset(at, blocks.back().fill, bytes);
    } else if (!blocks.empty()) {
      const std::size_t which = random() % blocks.size();
      right = right && isWhole(blocks[which]);
      reserve::release(blocks[which].at);
      blocks[which] = blocks.back();
      blocks.pop_back();
    }
  }
  for (const Block &block : blocks) {
    right = right && isWhole(block);
    reserve::release(block.at);
  }
}

TEST(Reserve, BlocksDoNotMeetOnSeveralThreads) {
  bool right[4] = {true, true, true, true};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < 4; ++i)
    threads.emplace_back(work, i + 1, std::ref(right[i]));
  for (std::thread &thread : threads)
    thread.join();
  for (const bool each : right)
    EXPECT_TRUE(each);
  EXPECT_FALSE(reserve::isLow());
}

TEST(Reserve, EndsAndIsWholeAgain) {
  for (int round = 0; round < 3; ++round) {
    std::vector<void *> blocks;
    while (void *const block = reserve::allocate(100'000))
      blocks.push_back(block);
    // Block sizes are powers of two, so that up to half of each may be wasted.
    EXPECT_GE(blocks.size(), 100u);
    EXPECT_TRUE(reserve::isLow());
    EXPECT_EQ(reserve::allocate(100'000), nullptr);
    for (void *const block : blocks)
      reserve::release(block);
    EXPECT_FALSE(reserve::isLow());
  }
  EXPECT_EQ(reserve::allocate(std::size_t(1) << (sizeof(void *) == 4 ? 31 : 40)), nullptr);
  EXPECT_EQ(reserve::allocate(~std::size_t(0)), nullptr);
  int own = 0;
  EXPECT_FALSE(reserve::has(&own));
  EXPECT_FALSE(reserve::has(nullptr));
}

} // namespace
} // namespace arbiter::fp::llvm_back
