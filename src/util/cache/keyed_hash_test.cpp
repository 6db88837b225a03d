/// SipHash-2-4-128 against its authors' vectors: the key 00 01 .. 0f, and a message 00 01 .. of
/// each length.
#include "util/cache/keyed_hash.h"

#include <string>

#include <gtest/gtest.h>

namespace arbiter {
namespace {

KeyedHash hashOfLength(std::size_t length) {
  HashKey key;
  for (std::size_t i = 0; i < key.size(); ++i)
    key[i] = std::uint8_t(i);
  std::string message;
  for (std::size_t i = 0; i < length; ++i)
    message.push_back(char(i));
  return keyedHash(key, message);
}

TEST(KeyedHash, IsThatOfTheAuthors) {
  EXPECT_EQ(hashOfLength(0), (KeyedHash{0xa3, 0x81, 0x7f, 0x04, 0xba, 0x25, 0xa8, 0xe6, 0x6d, 0xf6,
                                        0x72, 0x14, 0xc7, 0x55, 0x02, 0x93}));
  EXPECT_EQ(hashOfLength(1), (KeyedHash{0xda, 0x87, 0xc1, 0xd8, 0x6b, 0x99, 0xaf, 0x44, 0x34, 0x76,
                                        0x59, 0x11, 0x9b, 0x22, 0xfc, 0x45}));
  EXPECT_EQ(hashOfLength(7), (KeyedHash{0xa1, 0xf1, 0xeb, 0xbe, 0xd8, 0xdb, 0xc1, 0x53, 0xc0, 0xb8,
                                        0x4a, 0xa6, 0x1f, 0xf0, 0x82, 0x39}));
  EXPECT_EQ(hashOfLength(8), (KeyedHash{0x3b, 0x62, 0xa9, 0xba, 0x62, 0x58, 0xf5, 0x61, 0x0f, 0x83,
                                        0xe2, 0x64, 0xf3, 0x14, 0x97, 0xb4}));
  EXPECT_EQ(hashOfLength(15), (KeyedHash{0x54, 0x93, 0xe9, 0x99, 0x33, 0xb0, 0xa8, 0x11, 0x7e, 0x08,
                                         0xec, 0x0f, 0x97, 0xcf, 0xc3, 0xd9}));
  EXPECT_EQ(hashOfLength(63), (KeyedHash{0x51, 0x50, 0xd1, 0x77, 0x2f, 0x50, 0x83, 0x4a, 0x50, 0x3e,
                                         0x06, 0x9a, 0x97, 0x3f, 0xbd, 0x7c}));
}

TEST(KeyedHash, EveryBitOfKeyAndMessageMatters) {
  const HashKey key = {1, 2, 3};
  const std::string message = "some message of more than two words";
  const KeyedHash hash = keyedHash(key, message);
  for (std::size_t bit = 0; bit < 8 * key.size(); ++bit) {
    HashKey other = key;
    other[bit / 8] ^= std::uint8_t(1u << (bit % 8));
    EXPECT_NE(keyedHash(other, message), hash);
  }
  for (std::size_t bit = 0; bit < 8 * message.size(); ++bit) {
    std::string other = message;
    other[bit / 8] = char(other[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_NE(keyedHash(key, other), hash);
  }
}

} // namespace
} // namespace arbiter
