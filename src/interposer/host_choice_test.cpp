#include "interposer/host_choice.h"

#include <dlfcn.h>

#include <gtest/gtest.h>

extern "C" __attribute__((visibility("default"))) void arbiterTestEntry() {}

namespace arbiter::interposer {
namespace {

TEST(IcdLibraryPath, FindsThePathInAnIcdFile) {
  EXPECT_EQ(icdLibraryPath(R"({ "file_format_version" : "1.0.0",
                               "ICD" : { "library_path" : "libEGL_mesa.so.0" } })"),
            "libEGL_mesa.so.0");
  EXPECT_EQ(icdLibraryPath("{\"ICD\":{\"library_path\":\"/a \\\"b\\\"/c.so\"}}"), "/a \"b\"/c.so");
}

TEST(IcdLibraryPath, IsEmptyForFilesThatHaveNone) {
  EXPECT_EQ(icdLibraryPath(""), "");
  EXPECT_EQ(icdLibraryPath("{\"ICD\":{}}"), "");
  EXPECT_EQ(icdLibraryPath("{\"ICD\":{\"library_path\""), "");
  EXPECT_EQ(icdLibraryPath("{\"ICD\":{\"library_path\":"), "");
}

TEST(Candidates, NeverEmptyWithoutAnySelection) {
  EXPECT_FALSE(glxCandidates().empty());
  EXPECT_FALSE(eglCandidates().empty());
}

TEST(OpenHostLibrary, RefusesWhatHasNoVendorEntry) {
  EXPECT_EQ(openHostLibrary("libc.so.6", "__glx_Main"), nullptr);
  EXPECT_EQ(openHostLibrary("libGLX_no_such_vendor.so.0", "__glx_Main"), nullptr);
}

/// The test is linked with openHostLibrary, so that the test's own exported symbol counts as this
/// library's.
TEST(OpenHostLibrary, RefusesItself) {
  ASSERT_NE(dlsym(dlopen(nullptr, RTLD_LAZY), "arbiterTestEntry"), nullptr);
  EXPECT_EQ(openHostLibrary("/proc/self/exe", "arbiterTestEntry"), nullptr);
  EXPECT_EQ(openHostLibrary("", "arbiterTestEntry"), nullptr);
}

} // namespace
} // namespace arbiter::interposer
