#include "reports/system/hash.h"

#include <gtest/gtest.h>

namespace plumb::hash_test {
namespace {

// FIPS 180-2, appendix B.
TEST(Sha256, MatchesTheStandardsExamples) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, CountsZeroBytes) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_NE(sha256(""), sha256(std::string(1, '\0')));
}

// The offset basis of FNV-1a with 64 bits.
TEST(BitHash, DependsOnEveryBitAndOnTheOrder) {
  EXPECT_EQ(BitHash().value(), 0xcbf29ce484222325U);
  const auto hash_of_two = [](double a, double b) {
    BitHash hash;
    hash.add(a);
    hash.add(b);
    return hash.value();
  };
  EXPECT_NE(hash_of_two(1, 2), hash_of_two(2, 1));
  EXPECT_NE(hash_of_two(0.0, 0), hash_of_two(-0.0, 0));
}

}  // namespace
}  // namespace plumb::hash_test
