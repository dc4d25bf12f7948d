#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/figures/svg_figure.h"

// Figures as files: .svg, or .png where this build found librsvg, which draws the same document.
namespace voronaut {

// Whether a figure can be written under this name; asked before anything is computed. Throws
// std::invalid_argument that says which names can.
void check_figure_name(const std::string& file);

// Never half a figure. Throws as check_figure_name() does, std::runtime_error naming the file.
void write_figure(const std::vector<FigurePanel>& panels, const std::string& file);

// The document as PNG, with so many pixels per px of the document. Throws std::runtime_error for
// what is no SVG, is too large for a picture, or where this build has no librsvg.
std::string png_of_svg(std::string_view svg, double pixels_per_px);
bool can_write_png();

}  // namespace voronaut
