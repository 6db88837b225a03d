// Starts the tests of several sources that are linked into one program, which differ in their
// environments.
//
// usage: PROGRAM [SOURCE...]   runs the tests of the sources whose paths end so, of all without any
#include <gtest/gtest.h>
#include <iostream>
#include <set>
#include <string>

namespace {

/// Adds the tests of a source to a filter of Google Test.
/// \return how many sources have that name
std::size_t addTestsOf(const std::string &source, std::string &filter) {
  std::set<std::string> files;
  const auto &all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
    for (int j = 0; j < all.GetTestSuite(i)->total_test_count(); ++j) {
      const testing::TestInfo &test = *all.GetTestSuite(i)->GetTestInfo(j);
      if (!std::string(test.file()).ends_with("/" + source))
        continue;
      files.insert(test.file());
      filter += std::string(test.test_suite_name()) + "." + test.name() + ":";
    }
  return files.size();
}

} // namespace

int main(int argc, char **argv) {
  testing::InitGoogleTest(&argc, argv);
  std::string filter;
  for (int i = 1; i < argc; ++i)
    if (const std::size_t found = addTestsOf(argv[i], filter); found != 1) {
      std::cerr << argv[0] << ": " << found << " sources of tests are named " << argv[i] << "\n";
      return 2;
    }
  if (argc > 1)
    GTEST_FLAG_SET(filter, filter);
  return RUN_ALL_TESTS();
}
