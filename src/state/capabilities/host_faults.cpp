#include "state/capabilities/host_faults.h"

#include <charconv>
#include <iterator>

namespace arbiter::state {

namespace {

struct Row {
  HostFault fault;
  std::string_view driver;
  int first, last;
};
constexpr Row kRows[] = {
#define ARBITER_HOST_FAULT(Enumerator, driver, first, last, doc)                                   \
  {HostFault::Enumerator, driver, first, last},
#include "state/capabilities/host_faults.def"
#undef ARBITER_HOST_FAULT
};
static_assert(std::size(kRows) <= 32, "a bit each");

} // namespace

int releaseOf(std::string_view version, std::string_view driver) {
  const std::size_t at = version.find(driver);
  if (driver.empty() || at == version.npos)
    return 0;
  const char *const end = version.data() + version.size();
  const char *from = version.data() + at + driver.size();
  int numbers[2] = {};
  for (const char before : {' ', '.'}) {
    if (from == end || *from != before)
      return 0;
    int &number = numbers[before == '.' ? 1 : 0];
    const auto [rest, error] = std::from_chars(from + 1, end, number);
    if (error != std::errc() || number < 0)
      return 0;
    from = rest;
  }
  return 100 * numbers[0] + numbers[1];
}

std::uint32_t faultsOf(std::string_view version) {
  std::uint32_t faults = 0;
  for (const Row &row : kRows) {
    const int release = releaseOf(version, row.driver);
    if (release != 0 && release >= row.first && release <= row.last)
      faults |= bitOf(row.fault);
  }
  return faults;
}

} // namespace arbiter::state
