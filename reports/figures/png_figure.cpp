#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "voronaut/reports/figures/figure_file.h"

#ifdef VORONAUT_HAS_RSVG

#include <cairo.h>
#include <dlfcn.h>
#include <librsvg/rsvg.h>

namespace voronaut {

namespace {

// Loaded when the first figure is drawn: with what they stand on these are half of the program's
// mappings, which each child of a run would copy.
void* library() {
  static void* const loaded = dlopen("librsvg-2.so.2", RTLD_NOW | RTLD_LOCAL);
  return loaded;
}

// Of librsvg, or of cairo and glib, which come with it.
template <class Function>
Function* function(const char* name) {
  void* const found = dlsym(library(), name);
  if (found == nullptr) throw std::runtime_error(std::string("librsvg has no ") + name);
  return reinterpret_cast<Function*>(found);
}
#define VORONAUT_OF_RSVG(name) function<decltype(name)>(#name)

struct Release {
  void operator()(RsvgHandle* handle) const { VORONAUT_OF_RSVG(g_object_unref)(handle); }
  void operator()(cairo_surface_t* surface) const {
    VORONAUT_OF_RSVG(cairo_surface_destroy)(surface);
  }
  void operator()(cairo_t* pen) const { VORONAUT_OF_RSVG(cairo_destroy)(pen); }
  void operator()(GError* error) const { VORONAUT_OF_RSVG(g_error_free)(error); }
};
template <class Thing>
using Owned = std::unique_ptr<Thing, Release>;

[[noreturn]] void refuse(GError* error) {
  const Owned<GError> owned(error);
  throw std::runtime_error(std::string("the figure cannot be drawn: ") +
                           (error != nullptr ? error->message : "unknown size"));
}

cairo_status_t append(void* closure, const unsigned char* bytes, unsigned size) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("the figure cannot be drawn: ") +
                             VORONAUT_OF_RSVG(cairo_status_to_string)(status));
}

}  // namespace

bool can_write_png() { return library() != nullptr; }

std::string png_of_svg(std::string_view svg, double pixels_per_px) {
  if (library() == nullptr)
    throw std::runtime_error("librsvg cannot be loaded (Debian: librsvg2-2), which draws PNG");
  GError* error = nullptr;
  const Owned<RsvgHandle> figure(VORONAUT_OF_RSVG(rsvg_handle_new_from_data)(
      reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error));
  if (!figure) refuse(error);
  double width_px = 0;
  double height_px = 0;
  if (VORONAUT_OF_RSVG(rsvg_handle_get_intrinsic_size_in_pixels)(figure.get(), &width_px,
                                                                 &height_px) == FALSE)
    refuse(nullptr);

  const double width = std::ceil(width_px * pixels_per_px);
  const double height = std::ceil(height_px * pixels_per_px);
  const Owned<cairo_surface_t> surface(VORONAUT_OF_RSVG(cairo_image_surface_create)(
      CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  const Owned<cairo_t> pen(VORONAUT_OF_RSVG(cairo_create)(surface.get()));
  VORONAUT_OF_RSVG(cairo_set_source_rgb)
  (pen.get(), 1, 1, 1);  // where the figure ends within a pixel
  VORONAUT_OF_RSVG(cairo_paint)(pen.get());
  const RsvgRectangle page{0, 0, width, height};
  if (VORONAUT_OF_RSVG(rsvg_handle_render_document)(figure.get(), pen.get(), &page, &error) ==
      FALSE)
    refuse(error);
  require(VORONAUT_OF_RSVG(cairo_status)(pen.get()));

  std::string png;
  require(VORONAUT_OF_RSVG(cairo_surface_write_to_png_stream)(surface.get(), append, &png));
  return png;
}

#undef VORONAUT_OF_RSVG

}  // namespace voronaut

#else

namespace voronaut {

bool can_write_png() { return false; }

std::string png_of_svg(std::string_view, double) {
  throw std::runtime_error("this build has no librsvg (Debian: librsvg2-dev), which draws PNG");
}

}  // namespace voronaut

#endif
