#include "voronaut/reports/figures/figure_file.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voronaut {
namespace {

unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    value = 256 * value + static_cast<unsigned char>(bytes.at(i));
  }
  return value;
}

class PngFigure : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!can_write_png()) GTEST_SKIP() << "built without librsvg: no figure was drawn as PNG";
  }
};

TEST_F(PngFigure, HasTheSizeOfTheDocumentTimesTheScale) {
  const std::string png = png_of_svg(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="30.4" height="20"><path d="M0 0h9"/></svg>)",
      2);
  ASSERT_THAT(png, ::testing::StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(big_endian(png, 16), 61U);  // width and height follow the header's name (RFC 2083)
  EXPECT_EQ(big_endian(png, 20), 40U);
}

TEST_F(PngFigure, RefusesWhatIsNoDocumentOrTooLarge) {
  EXPECT_THROW(png_of_svg("no picture", 1), std::runtime_error);
  EXPECT_THROW(
      png_of_svg(R"(<svg xmlns="http://www.w3.org/2000/svg" width="90000" height="90000"/>)", 2),
      std::runtime_error);
}

TEST(FigureFile, AnotherEndingIsRefusedBeforeAnythingIsWritten) {
  EXPECT_NO_THROW(check_figure_name("a.svg"));
  EXPECT_THROW(write_figure({}, "picture.jpeg"), std::invalid_argument);
  EXPECT_THROW(check_figure_name("svg"), std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
