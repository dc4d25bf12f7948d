#include "voronaut/environments/formats/png_image.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "voronaut/environments/formats/ros_map.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

// A PNG file of so many columns, of libpng's simplified formats; a colour map where it has one.
template <class Channel>
std::string png_of(png_uint_32 format, png_uint_32 columns, const std::vector<Channel>& channels,
                   const std::vector<png_byte>& palette = {}) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = format;
  image.width = columns;
  image.height =
      static_cast<png_uint_32>(channels.size()) / PNG_IMAGE_PIXEL_CHANNELS(format) / columns;
  image.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
  const void* map = palette.empty() ? nullptr : palette.data();
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, channels.data(), 0, map);
  std::string bytes(size, '\0');
  png_image_write_to_memory(&image, bytes.data(), &size, 0, channels.data(), 0, map);
  return bytes;
}

using Bytes = std::vector<png_byte>;

// As parts of white.
std::vector<double> shades(const std::string& png, PngAlpha alpha = PngAlpha::channel) {
  const GreyImage image = parse_png(png, "m.png", alpha);
  std::vector<double> shades;
  for (const std::uint32_t value : image.values)
    shades.push_back(static_cast<double>(value) / image.white);
  return shades;
}

std::string png_error(const std::string& bytes) {
  return error_of<ConfigError>([&] { parse_png(bytes, "m.png", PngAlpha::channel); });
}

TEST(Png, HasItsRowsFromTheTop) {
  const GreyImage image = parse_png(png_of(PNG_FORMAT_GRAY, 3, Bytes{0, 51, 255, 102, 153, 204}),
                                    "m.png", PngAlpha::channel);
  EXPECT_EQ(image.columns, 3);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.value(1, 0) * 5, image.white);
  EXPECT_EQ(image.value(0, 1) * 5, image.white * 2);
  EXPECT_FALSE(image.is_unknown(0, 0));
}

TEST(Png, IsTheMeanOfItsChannels) {
  EXPECT_EQ(shades(png_of(PNG_FORMAT_GRAY, 2, Bytes{0, 255})), (std::vector<double>{0, 1}));
  EXPECT_EQ(shades(png_of(PNG_FORMAT_RGB, 2, Bytes{255, 0, 0, 51, 102, 153})),
            (std::vector<double>{1.0 / 3, 0.4}));
  EXPECT_EQ(
      shades(png_of(PNG_FORMAT_RGB_COLORMAP, 3, Bytes{1, 0, 1}, {0, 0, 0, 255, 255, 0, 9, 9, 9})),
      (std::vector<double>{2.0 / 3, 0, 2.0 / 3}));
  EXPECT_EQ(shades(png_of(PNG_FORMAT_LINEAR_Y, 2, std::vector<png_uint_16>{13107, 65535})),
            (std::vector<double>{0.2, 1}));
}

TEST(Png, CountsOpacityAsOneMoreChannelInTheModeTrinary) {
  EXPECT_EQ(shades(png_of(PNG_FORMAT_GA, 2, Bytes{255, 0, 0, 255})),
            (std::vector<double>{0.75, 0.25}));
  EXPECT_EQ(shades(png_of(PNG_FORMAT_RGBA, 1, Bytes{255, 0, 0, 255})), (std::vector<double>{0.5}));
}

TEST(Png, IsUnknownWhereItIsNotOpaqueInTheModeScale) {
  const std::string png = png_of(PNG_FORMAT_GA, 3, Bytes{255, 255, 0, 254, 255, 0});
  EXPECT_EQ(shades(png, PngAlpha::unknown), (std::vector<double>{1, 0, 1}));
  RosMapDescription map;
  const auto blocked = [&](PngAlpha alpha, UnknownCells unknown) {
    const BlockedCells cells = ros_map_cells(map, parse_png(png, "m.png", alpha), unknown);
    return std::string{cells.blocked(0, 0) ? '#' : '.', cells.blocked(1, 0) ? '#' : '.',
                       cells.blocked(2, 0) ? '#' : '.'};
  };
  EXPECT_EQ(blocked(PngAlpha::unknown, UnknownCells::free), "...");
  EXPECT_EQ(blocked(PngAlpha::unknown, UnknownCells::blocked), ".##");
  EXPECT_EQ(blocked(PngAlpha::channel, UnknownCells::free), ".#.");  // 0.75, 0.25, 0.75 of white
}

TEST(Png, IsRefusedWithTheReason) {
  const std::string whole = png_of(PNG_FORMAT_GRAY, 3, Bytes{0, 51, 255, 102, 153, 204});
  EXPECT_EQ(png_error(""), "m.png: not a PNG image that can be read: it does not begin like one");
  EXPECT_EQ(png_error(whole.substr(0, whole.size() - 20)),
            "m.png: not a PNG image that can be read: the file ends too early");
  std::string broken = whole;
  broken[20] = '\1';  // of the size
  EXPECT_EQ(png_error(broken), "m.png: not a PNG image that can be read: IHDR: CRC error");
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(png_error(whole.substr(0, length)), "no error") << length;
}

}  // namespace
}  // namespace voronaut
