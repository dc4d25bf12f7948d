#include "voronaut/reports/figures/figure_file.h"

#include <filesystem>
#include <stdexcept>

#include "voronaut/reports/store/atomic_file.h"

namespace voronaut {

namespace {

constexpr double kPixelsPerPx = 2;  // fonts of 13 px stay readable in print

std::string ending_of(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

}  // namespace

void check_figure_name(const std::string& file) {
  const std::string ending = ending_of(file);
  if (ending == ".svg" || (ending == ".png" && can_write_png())) return;
  const std::string wrong = "-o '" + file + "': ";
  if (ending == ".png")
    throw std::invalid_argument(wrong + "this build has no librsvg (Debian: librsvg2-dev), which " +
                                "draws .png; a name that ends in .svg is possible");
  throw std::invalid_argument(wrong + "expected a name that ends in .svg" +
                              (can_write_png() ? " or .png" : ""));
}

void write_figure(const std::vector<FigurePanel>& panels, const std::string& file) {
  check_figure_name(file);
  const std::string svg = svg_figure(panels);
  write_file_atomically(file, ending_of(file) == ".png" ? png_of_svg(svg, kPixelsPerPx) : svg);
}

}  // namespace voronaut
