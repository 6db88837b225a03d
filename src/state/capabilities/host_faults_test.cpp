#include "state/capabilities/host_faults.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

TEST(HostFaults, AReleaseIsReadFromTheVersion) {
  EXPECT_EQ(releaseOf("4.5 (Compatibility Profile) Mesa 22.3.6", "Mesa"), 2203);
  EXPECT_EQ(releaseOf("2.1 Mesa 25.0.0-devel (git-0123)", "Mesa"), 2500);
  EXPECT_EQ(releaseOf("4.6.0 NVIDIA 580.159", "NVIDIA"), 58159);
  for (const char *const version : {"", "4.6.0 NVIDIA 580.159", "4.5 Mesa", "4.5 Mesa ",
                                    "4.5 Mesa 22", "4.5 Mesa 22.", "4.5 Mesa x.3", "4.5 Mesa22.3"})
    EXPECT_EQ(releaseOf(version, "Mesa"), 0) << version;
}

TEST(HostFaults, AreThoseOfTheDriversReleases) {
  const std::uint32_t letters = bitOf(HostFault::KeptLetters);
  EXPECT_EQ(faultsOf("4.5 (Compatibility Profile) Mesa 22.3.6") & letters, letters);
  EXPECT_EQ(faultsOf("4.5 (Compatibility Profile) Mesa 20.0.8") & letters, 0u);
  EXPECT_EQ(faultsOf("4.6.0 NVIDIA 580.159"), 0u);
  EXPECT_EQ(faultsOf(""), 0u);
}

} // namespace
} // namespace arbiter::state
