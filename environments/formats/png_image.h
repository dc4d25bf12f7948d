#pragma once

#include <string>
#include <string_view>

#include "voronaut/environments/formats/pgm.h"

namespace voronaut {

// What map_server makes of an image's opacity (nav2_map_server/src/map_io.cpp): in the mode trinary
// one more channel of the mean, in the mode scale what makes a pixel unknown unless it is full.
enum class PngAlpha { channel, unknown };

// A PNG image (https://www.w3.org/TR/png) as map_server takes it: each pixel is the sum of its
// channels, three of colour (a grey one counts as three equal ones, a palette's entries are
// colours) and, with PngAlpha::channel, its opacity where the image has one; white is as many times
// the largest value. Gamma and colour profiles are not looked at. Throws ConfigError.
GreyImage parse_png(std::string_view bytes, const std::string& file, PngAlpha alpha);

bool is_png(std::string_view bytes);

}  // namespace voronaut
