#include "voronaut/environments/formats/png_image.h"

#include <csetjmp>
#include <cstring>
#include <vector>

#include <png.h>

#include "voronaut/environments/config/config_error.h"
#include "voronaut/environments/formats/blocked_cells.h"

namespace voronaut {
namespace {

constexpr std::size_t kSignatureLength = 8;
// What a chunk beside the pixels, a profile or a text, may take.
constexpr png_alloc_size_t kLargestChunk_bytes = 1 << 20;

// libpng reports faults by a jump out of its calls. No object with a destructor may begin its life
// in a function that it jumps through, so all that is read lies in here.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes) : bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  // Size and kind of the image, and what its rows will be: grey or colours, with opacity or
  // without, of 8 or 16 bits. False for a fault.
  bool read_header() {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, on_read);
    png_set_user_limits(png_, BlockedCells::kLongestSide, BlockedCells::kLongestSide);
    png_set_chunk_malloc_max(png_, kLargestChunk_bytes);
    png_read_info(png_, info_);
    png_set_expand(
        png_);  // palettes and few bits to whole channels, a transparent colour to opacity
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  // The rows of the image, one behind the other. False for a fault.
  bool read_pixels() {
    pixels_.resize(row_bytes() * height());
    rows_.resize(height());
    for (std::size_t row = 0; row < rows_.size(); ++row)
      rows_[row] = pixels_.data() + row * row_bytes();
    return read_rows();
  }

  int columns() const { return static_cast<int>(png_get_image_width(png_, info_)); }
  int rows() const { return static_cast<int>(height()); }
  int channels() const { return png_get_channels(png_, info_); }
  bool wide() const { return png_get_bit_depth(png_, info_) == 16; }
  std::uint32_t value(std::size_t index) const {
    if (!wide()) return pixels_[index];
    return pixels_[2 * index] * 256U + pixels_[2 * index + 1];
  }
  const char* problem() const { return problem_; }

 private:
  std::size_t height() const { return png_get_image_height(png_, info_); }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

  bool read_rows() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_image(png_, rows_.data());
    png_read_end(png_, nullptr);
    return true;
  }

  static void on_read(png_structp png, png_bytep to, std::size_t count) {
    auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (count > reader.bytes_.size() - reader.at_) png_error(png, "the file ends too early");
    std::memcpy(to, reader.bytes_.data() + reader.at_, count);
    reader.at_ += count;
  }

  static void on_error(png_structp png, png_const_charp message) {
    auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(reader.problem_, message, sizeof reader.problem_ - 1);
    png_longjmp(png, 1);
  }
  static void on_warning(png_structp, png_const_charp) {}

  std::string_view bytes_;
  std::size_t at_ = 0;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<unsigned char> pixels_;
  std::vector<png_bytep> rows_;
  char problem_[100] = "no memory";
};

// Of one pixel; a single grey counts as red, green and blue.
std::uint32_t sum_of_colours(const PngReader& png, std::size_t first, std::size_t colours) {
  if (colours == 1) return 3 * png.value(first);
  std::uint32_t sum = 0;
  for (std::size_t c = 0; c < colours; ++c) sum += png.value(first + c);
  return sum;
}

// Sums of the channels, so that no rounding comes before map_server's own.
GreyImage grey_image(const PngReader& png, PngAlpha alpha) {
  GreyImage image;
  image.columns = png.columns();
  image.rows = png.rows();
  const auto channels = static_cast<std::size_t>(png.channels());
  const bool has_alpha = channels == 2 || channels == 4;
  const std::size_t colours = has_alpha ? channels - 1 : channels;
  const std::uint32_t largest = png.wide() ? 65535 : 255;
  const bool adds_alpha = has_alpha && alpha == PngAlpha::channel;
  image.white = static_cast<int>(largest) * (adds_alpha ? 4 : 3);
  const std::size_t pixels = std::size_t(image.columns) * std::size_t(image.rows);
  image.values.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t sum = sum_of_colours(png, i * channels, colours);
    const std::uint32_t opacity = has_alpha ? png.value(i * channels + colours) : largest;
    image.values.push_back(adds_alpha ? sum + opacity : sum);
    if (has_alpha && !adds_alpha) image.unknown.push_back(opacity != largest);
  }
  return image;
}

}  // namespace

bool is_png(std::string_view bytes) {
  return bytes.size() >= kSignatureLength &&
         png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignatureLength) == 0;
}

GreyImage parse_png(std::string_view bytes, const std::string& file, PngAlpha alpha) {
  PngReader png(bytes);
  const auto error = [&](const std::string& problem) {
    return ConfigError(file, 0, "", "not a PNG image that can be read: " + problem);
  };
  if (!is_png(bytes)) throw error("it does not begin like one");
  if (!png.read_header()) throw error(png.problem());
  if (!BlockedCells::may_have(png.columns(), png.rows()))
    throw error("more than " + std::to_string(BlockedCells::kMostCells) + " pixels");
  if (!png.read_pixels()) throw error(png.problem());

  return grey_image(png, alpha);
}

}  // namespace voronaut
