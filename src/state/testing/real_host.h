#pragma once
#include <cstdint>
#include <random>
#include <vector>

#include "host/host_table.h"
#include "state/raster_draw/raster_context.h"

/// A context of the real host (OSMesa over llvmpipe) with the layer's context in front of it. For
/// tests of what the layer queries.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::testing {

class RealHost {
public:
  RealHost(int width = 64, int height = 64);
  ~RealHost();
  RealHost(const RealHost &) = delete;
  RealHost &operator=(const RealHost &) = delete;

  /// False if there is no host to test with.
  [[nodiscard]] bool valid() const { return m_context != nullptr; }
  [[nodiscard]] RasterContext &context() const;
  [[nodiscard]] const host::HostTable &gl() const { return *context().host; }

private:
  std::vector<std::uint8_t> m_pixels;
  void *m_osmesa = nullptr;
  Context *m_context = nullptr;
};

/// Returns a host function that the host's library does not export.
[[nodiscard]] void *address(const char *name);

/// Random numbers from a seed, the same on every machine.
class Numbers {
public:
  explicit Numbers(std::uint64_t seed) : m_engine(seed) {}
  int below(int count) { return int(m_engine() % std::uint64_t(count)); }
  bool chance(int percent) { return below(100) < percent; }
  float real(float low, float high) { return low + (high - low) * float(below(4096)) / 4096.0f; }
  template <typename T, std::size_t count> T of(const T (&values)[count]) {
    return values[std::size_t(below(int(count)))];
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace arbiter::state::testing
