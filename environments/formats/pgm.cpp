#include "voronaut/environments/formats/pgm.h"

#include <algorithm>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/blocked_cells.h"

namespace voronaut {
namespace {

constexpr std::string_view kBlank = " \t\r\n\v\f";

// The numbers of a header or of plain data, with comments from '#' to the end of the line.
class PgmText {
 public:
  PgmText(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  std::string_view word(const char* what) {
    skip_blanks_and_comments();
    if (at_ == bytes_.size()) throw error(std::string("the file ends before the ") + what);
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && kBlank.find(bytes_[at_]) == std::string_view::npos &&
           bytes_[at_] != '#')
      ++at_;
    return bytes_.substr(begin, at_ - begin);
  }

  int whole(const char* what, int lo, int hi) {
    const std::string_view text = word(what);
    const auto value = parse_whole(text);
    if (!value || *value < lo || *value > hi)
      throw error(std::string(what) + ": expected a whole number from " + std::to_string(lo) +
                  " to " + std::to_string(hi) + ", got " + in_quotes(text));
    return static_cast<int>(*value);
  }

  // What follows the single blank after the header, so many bytes; map_saver writes the end of a
  // line behind them. Were the header's blank two, "\r\n", all pixels would be moved by one.
  std::string_view raw_data(std::size_t size) {
    const bool moved = bytes_.substr(at_).starts_with("\r\n");
    const std::string_view data = bytes_.substr(std::min(at_ + 1, bytes_.size()));
    const std::string_view rest = data.substr(std::min(size, data.size()));
    if (data.size() < size || (!rest.empty() && (moved || (rest != "\n" && rest != "\r\n"))))
      throw error("expected " + std::to_string(size) + " bytes of pixels, got " +
                  std::to_string(data.size()) +
                  (moved ? " (the header ends in \\r\\n; one blank must end it)" : ""));
    return data.substr(0, size);
  }

  void expect_end() {
    skip_blanks_and_comments();
    if (at_ < bytes_.size()) throw error("more pixels than width and height say");
  }

  ConfigError error(const std::string& problem) const { return {file_, line_, "", problem}; }

 private:
  void skip_blanks_and_comments() {
    for (bool comment = false; at_ < bytes_.size(); ++at_) {
      const char c = bytes_[at_];
      if (c == '\n') {
        ++line_;
        comment = false;
      } else if (c == '#') {
        comment = true;
      } else if (!comment && kBlank.find(c) == std::string_view::npos) {
        return;
      }
    }
  }

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

void read_raw(PgmText& text, GreyImage& image, std::size_t pixels) {
  const std::size_t bytes_each = image.white > 255 ? 2 : 1;
  const std::string_view data = text.raw_data(pixels * bytes_each);
  image.values.reserve(pixels);
  for (std::size_t i = 0; i < pixels * bytes_each; i += bytes_each) {
    int value = static_cast<unsigned char>(data[i]);
    if (bytes_each == 2) value = value * 256 + static_cast<unsigned char>(data[i + 1]);
    if (value > image.white)
      throw text.error("pixel " + std::to_string(i / bytes_each) + " is " + std::to_string(value) +
                       ", above the maximum " + std::to_string(image.white));
    image.values.push_back(static_cast<std::uint32_t>(value));
  }
}

}  // namespace

GreyImage parse_pgm(std::string_view bytes, const std::string& file) {
  PgmText text(bytes, file);
  const std::string_view magic = text.word("sign P2 or P5");
  if (magic != "P2" && magic != "P5")
    throw text.error("expected a PGM image (P2 or P5), got " + in_quotes(magic));
  GreyImage image;
  image.columns = text.whole("width", 1, BlockedCells::kLongestSide);
  image.rows = text.whole("height", 1, BlockedCells::kLongestSide);
  if (!BlockedCells::may_have(image.columns, image.rows))
    throw text.error("more than " + std::to_string(BlockedCells::kMostCells) + " pixels");
  image.white = text.whole("maximum", 1, 65535);
  const std::size_t pixels =
      static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  if (magic == "P5") {
    read_raw(text, image, pixels);
  } else {
    for (std::size_t i = 0; i < pixels; ++i)
      image.values.push_back(static_cast<std::uint32_t>(text.whole("pixels", 0, image.white)));
    text.expect_end();
  }
  return image;
}

}  // namespace voronaut
