#include "state/raster_draw/vertices/buffer_copies.h"

#include <gtest/gtest.h>

#include "state/mirror/attribute_groups.h"
#include "state/mirror/generation_counter.h"

namespace arbiter::state {
namespace {

class BufferCopiesTest : public ::testing::Test {
protected:
  [[nodiscard]] BufferCopies::Contents contents() const { return {m_bytes.data(), m_bytes.size()}; }
  void draw(GLuint buffer) {
    if (!m_copies.find(m_clock, buffer).data)
      m_copies.drawnFrom(buffer, contents());
  }
  std::vector<std::uint8_t> m_bytes = {1, 2, 3, 4};
  GenerationCounter m_clock;
  BufferCopies m_copies;
};

TEST_F(BufferCopiesTest, KeepsWhatIsDrawnFromTwice) {
  draw(7);
  EXPECT_FALSE(m_copies.find(m_clock, 7).data) << "a buffer that is drawn from once is not copied";
  draw(7);
  const BufferCopies::Contents copy = m_copies.find(m_clock, 7);
  ASSERT_TRUE(copy.data);
  EXPECT_NE(copy.data, m_bytes.data()) << "the host unmaps it";
  EXPECT_EQ(std::vector<std::uint8_t>(copy.data, copy.data + copy.bytes), m_bytes);
  EXPECT_FALSE(m_copies.find(m_clock, 8).data) << "another buffer";
}

TEST_F(BufferCopiesTest, ForgetsAllAtAChangeOfBuffersAndAtNoOther) {
  draw(7);
  draw(7);
  m_clock.mark(dirty::kAll & ~dirty::kBuffers);
  EXPECT_TRUE(m_copies.find(m_clock, 7).data);
  m_clock.mark(dirty::kBuffers);
  EXPECT_FALSE(m_copies.find(m_clock, 7).data);
  draw(7);
  EXPECT_FALSE(m_copies.find(m_clock, 7).data) << "once since the change";
}

TEST_F(BufferCopiesTest, LeavesLargeBuffersAndWhatIsTooMuch) {
  m_bytes.assign(1 << 20, 5);
  draw(7);
  draw(7);
  EXPECT_FALSE(m_copies.find(m_clock, 7).data);
  m_bytes.assign(60 << 10, 5);
  int kept = 0;
  for (GLuint buffer = 100; buffer < 400; ++buffer) {
    draw(buffer);
    draw(buffer);
  }
  for (GLuint buffer = 100; buffer < 400; ++buffer)
    kept += m_copies.find(m_clock, buffer).data != nullptr;
  EXPECT_GT(kept, 4);
  EXPECT_LT(kept, 20) << "a mebibyte in all";
}

TEST(GenerationCounterTest, TellsAGroupToAReaderHoweverLateItLooks) {
  GenerationCounter clock;
  EXPECT_EQ(clock.changedSince(0) & 0xFFFFu, 0xFFFFu) << "a reader that never looked";
  const std::uint64_t first = clock.now();
  EXPECT_EQ(clock.changedSince(first), 0u);
  clock.mark(dirty::kFog);
  EXPECT_EQ(clock.changedSince(first), dirty::kFog);
  const std::uint64_t second = clock.now();
  clock.mark(dirty::kRaster | dirty::kBuffers);
  EXPECT_EQ(clock.changedSince(second), dirty::kRaster | dirty::kBuffers);
  EXPECT_EQ(clock.changedSince(first), dirty::kFog | dirty::kRaster | dirty::kBuffers);
}

TEST(AttributeGroups, NameWhatAPopRestores) {
  EXPECT_EQ(dirtyGroupsOfAttributes(GL_FOG_BIT) & dirty::kFog, dirty::kFog);
  EXPECT_EQ(dirtyGroupsOfAttributes(GL_FOG_BIT) & (dirty::kArrays | dirty::kPixelOps), 0u);
  EXPECT_EQ(dirtyGroupsOfAttributes(GL_ALL_ATTRIB_BITS), dirty::kAll);
  EXPECT_EQ(dirtyGroupsOfAttributes(0x40000000u), dirty::kAll) << "a group that we do not know of";
  const std::uint32_t color = dirtyGroupsOfAttributes(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(color & dirty::kFramebuffer, dirty::kFramebuffer) << "DRAW_BUFFER is in it";
}

/// Must be the last test, because stop() affects the process.
TEST_F(BufferCopiesTest, NothingIsCopiedWhereMemoryIsTheApplications) {
  draw(7);
  draw(7);
  ASSERT_TRUE(m_copies.find(m_clock, 7).data);
  BufferCopies::stop();
  m_clock.mark(dirty::kBuffers); // as the command that gives the memory does
  for (int i = 0; i < 3; ++i)
    draw(7);
  EXPECT_FALSE(m_copies.find(m_clock, 7).data);
}

} // namespace
} // namespace arbiter::state
