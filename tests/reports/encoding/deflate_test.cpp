#include "voronaut/reports/encoding/deflate.h"

#include <random>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(Deflate, GivesBackWhatItWasGiven) {
  std::mt19937_64 engine(7);
  for (const std::size_t size : {0U, 1U, 1000U, 65536U, 65537U, 1000000U}) {
    std::string bytes(size, '\0');
    for (char& c : bytes) {
      c = static_cast<char>(engine() % 5);
    }
    EXPECT_EQ(inflate_raw(deflate_raw(bytes)), bytes) << "size " << size;
  }
}

TEST(Deflate, RefusesATruncatedStreamTrailingBytesAndGarbage) {
  const std::string whole = deflate_raw(std::string(5000, 'a') + "tail");
  EXPECT_THROW(inflate_raw(std::string_view(whole).substr(0, whole.size() - 1)),
               std::invalid_argument);
  EXPECT_THROW(inflate_raw(whole + "x"), std::invalid_argument);
  EXPECT_THROW(inflate_raw("\xff\xff\xff garbage"), std::invalid_argument);
  EXPECT_THROW(inflate_raw(""), std::invalid_argument);
}

TEST(Deflate, StopsAtTheStatedSize) {
  const std::string bomb = deflate_raw(std::string(10'000'000, 'a'));
  EXPECT_LT(bomb.size(), 50'000U);
  EXPECT_THROW(inflate_raw(bomb, 1'000'000), std::invalid_argument);
}

TEST(Base64, MatchesTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace voronaut
