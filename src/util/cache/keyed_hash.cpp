#include "util/cache/keyed_hash.h"

#include <bit>
#include <cstddef>

namespace arbiter {

namespace {

/// Reads a little-endian word on any machine, so that a message has the same hash everywhere.
std::uint64_t load(const char *from, std::size_t bytes) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < bytes; ++i)
    word |= std::uint64_t(static_cast<unsigned char>(from[i])) << (8 * i);
  return word;
}

void store(std::uint64_t word, std::uint8_t *to) {
  for (int i = 0; i < 8; ++i)
    to[i] = std::uint8_t(word >> (8 * i));
}

struct State {
  std::uint64_t v0, v1, v2, v3;

  void round() {
    v0 += v1;
    v2 += v3;
    v1 = std::rotl(v1, 13) ^ v0;
    v3 = std::rotl(v3, 16) ^ v2;
    v0 = std::rotl(v0, 32);
    v2 += v1;
    v0 += v3;
    v1 = std::rotl(v1, 17) ^ v2;
    v3 = std::rotl(v3, 21) ^ v0;
    v2 = std::rotl(v2, 32);
  }
  void take(std::uint64_t word) {
    v3 ^= word;
    round();
    round();
    v0 ^= word;
  }
  std::uint64_t finish() {
    for (int i = 0; i < 4; ++i)
      round();
    return v0 ^ v1 ^ v2 ^ v3;
  }
};

} // namespace

KeyedHash keyedHash(const HashKey &key, std::string_view message) {
  const auto *const bytes = reinterpret_cast<const char *>(key.data());
  const std::uint64_t k0 = load(bytes, 8), k1 = load(bytes + 8, 8);
  // The constants spell "somepseudorandomlygeneratedbytes". 0xee marks the 128-bit result.
  State state = {k0 ^ 0x736f6d6570736575u, k1 ^ 0x646f72616e646f6du ^ 0xeeu,
                 k0 ^ 0x6c7967656e657261u, k1 ^ 0x7465646279746573u};
  std::size_t at = 0;
  for (; message.size() - at >= 8; at += 8)
    state.take(load(message.data() + at, 8));
  state.take(load(message.data() + at, message.size() - at) | std::uint64_t(message.size()) << 56);
  KeyedHash hash;
  state.v2 ^= 0xee;
  store(state.finish(), hash.data());
  state.v1 ^= 0xdd;
  store(state.finish(), hash.data() + 8);
  return hash;
}

} // namespace arbiter
