#include "voronaut/reports/figures/svg_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "voronaut/reports/figures/figure_extent.h"
#include "voronaut/reports/page/report_data.h"

namespace voronaut {

namespace {

// Okabe and Ito's colours, darkened where white would swallow them; the report uses the same.
constexpr std::array<const char*, 8> kColours{"#0072b2", "#d55e00", "#007a5a", "#a8488a",
                                              "#8a6000", "#2b8cbe", "#5b3fa8", "#44484d"};
constexpr std::array<const char*, 8> kDashes{"",     "7 3", "2 3", "9 3 2 3",
                                             "12 4", "4 2", "1 2", "6 2 2 2 2 2"};
constexpr double kWidthMin = 320;  // px: room for the legend
constexpr double kSmallestBody_px = 2;
constexpr double kGap = 18;  // px between panels, and around them

// Two decimals are a hundredth of a pixel; no locale, no "-0.00".
std::string px(double value) {
  std::array<char, 32> buffer{};
  const double rounded = std::round(value * 100.0) / 100.0;
  std::snprintf(buffer.data(), buffer.size(), "%.7g", rounded == 0.0 ? 0.0 : rounded);
  return buffer.data();
}

struct Style {
  std::string stroke;  // attributes
  std::string colour;
};

class Figure {
 public:
  Figure(const std::vector<FigurePanel>& panels, const FigureConfig& config)
      : panels_(panels), config_(config) {
    for (const FigurePanel& panel : panels) {
      for (const FigureTrack& track : panel.tracks) {
        if (std::find(labels_.begin(), labels_.end(), track.label) == labels_.end()) {
          labels_.push_back(track.label);
        }
      }
    }
  }

  std::string draw() {
    const double title_height = 1.7 * config_.font_size_px;
    double y = kGap;
    double width = 0;
    for (std::size_t row = 0; row < panels_.size();
         row += static_cast<std::size_t>(config_.columns)) {
      const std::size_t end =
          std::min(panels_.size(), row + static_cast<std::size_t>(config_.columns));
      double x = kGap;
      double height = 0;
      for (std::size_t i = row; i < end; ++i) {
        text(x, y + config_.font_size_px, panels_[i].title, "font-weight=\"600\"");
        const auto [w, h] = panel(panels_[i], x, y + title_height);
        x += w + kGap;
        height = std::max(height, h);
      }
      width = std::max(width, x);
      y += title_height + height + kGap;
    }
    y = legend(y);
    width = std::max(width, kWidthMin);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + px(width) + " " + px(y) +
           "\" width=\"" + px(width) + "\" height=\"" + px(y) +
           "\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" font-size=\"" +
           px(config_.font_size_px) +
           "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" + body_ + "</svg>\n";
  }

 private:
  struct View {
    double left, top, scale;
    TracePoint minimum, maximum;
    double x(double x_m) const { return left + (x_m - minimum.x_m) * scale; }
    double y(double y_m) const { return top + (maximum.y_m - y_m) * scale; }
    double width() const { return (maximum.x_m - minimum.x_m) * scale; }
    double height() const { return (maximum.y_m - minimum.y_m) * scale; }
  };

  Style style_of(const std::string& label) const {
    const auto i = static_cast<std::size_t>(std::find(labels_.begin(), labels_.end(), label) -
                                            labels_.begin());
    const std::string colour = kColours[i % kColours.size()];
    const std::string dash = kDashes[(i + i / kColours.size()) % kDashes.size()];
    return {"fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"2\" stroke-linejoin=\"round\"" +
                (dash.empty() ? "" : " stroke-dasharray=\"" + dash + "\""),
            colour};
  }

  void text(double x, double y, const std::string& words, const std::string& attributes) {
    body_ += "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\"" + (attributes.empty() ? "" : " ") +
             attributes + ">" + escaped_for_html(words) + "</text>\n";
  }

  template <class Points>
  std::string path(const View& view, const Points& points, bool closed) const {
    std::string d;
    for (const auto& p : points) {
      d += (d.empty() ? "M" : "L") + px(view.x(p.x_m)) + " " + px(view.y(p.y_m));
    }
    return d + (closed ? "Z" : "");
  }

  void world(const View& view, const TraceWorld& world) {
    body_ += "<g fill=\"#c9ced6\" stroke=\"#8a939d\">\n";
    for (const auto& [x_m, y_m, radius_m] : world.circles) {
      body_ += "<circle cx=\"" + px(view.x(x_m)) + "\" cy=\"" + px(view.y(y_m)) + "\" r=\"" +
               px(radius_m * view.scale) + "\"/>\n";
    }
    // One path: rings that run clockwise are holes in those around them.
    std::string rings;
    for (const auto& polygon : world.polygons) rings += path(view, polygon, true);
    if (!rings.empty()) body_ += "<path d=\"" + rings + "\"/>\n";
    for (const auto& segment : world.segments) {
      body_ += "<path stroke-width=\"3\" d=\"" + path(view, segment, false) + "\"/>\n";
    }
    body_ += "</g>\n";
    body_ += "<rect x=\"" + px(view.left) + "\" y=\"" + px(view.top) + "\" width=\"" +
             px(view.width()) + "\" height=\"" + px(view.height()) +
             "\" fill=\"none\" stroke=\"#8a939d\"/>\n";
  }

  void known(const View& view, const Trace& trace) {
    body_ += "<g fill=\"none\" stroke=\"#6f42c1\" stroke-dasharray=\"3 2\">\n";
    for (const auto& hull : trace.hulls) {
      body_ += "<path d=\"" + path(view, hull, true) + "\"/>\n";
    }
    body_ +=
        "</g>\n<path fill=\"none\" stroke=\"#1b1f24\" stroke-width=\"2.4\" "
        "stroke-linecap=\"round\" d=\"";
    for (const TracePoint& p : trace.known_points) {
      body_ += "M" + px(view.x(p.x_m)) + " " + px(view.y(p.y_m)) + "h0";
    }
    body_ += "\"/>\n";
  }

  // The disc, or the polygon as it is turned.
  std::string body(const View& view, const Trace& trace, const TraceFrame& at) const {
    const double radius_px = trace.body_radius_m * view.scale;
    if (trace.footprint.empty() || radius_px < kSmallestBody_px)
      return "<circle cx=\"" + px(view.x(at.x_m)) + "\" cy=\"" + px(view.y(at.y_m)) + "\" r=\"" +
             px(std::max(kSmallestBody_px, radius_px)) + "\"";
    std::vector<TracePoint> corners;
    for (const auto& [ahead_m, left_m] : trace.footprint)
      corners.push_back({at.x_m + ahead_m * at.heading_x - left_m * at.heading_y,
                         at.y_m + ahead_m * at.heading_y + left_m * at.heading_x});
    return "<path d=\"" + path(view, corners, true) + "\"";
  }

  void track(const View& view, const FigureTrack& track) {
    const Style style = style_of(track.label);
    body_ += "<path " + style.stroke + " d=\"" + path(view, track.trace.frames, false) + "\"/>\n";
    if (track.trace.frames.empty()) {
      return;
    }
    const TraceFrame& end = track.trace.frames.back();
    body_ += body(view, track.trace, end) + " fill=\"" + style.colour +
             "\" fill-opacity=\"0.2\" stroke=\"" + style.colour + "\"/>\n";
    text(view.x(end.x_m), view.y(end.y_m) + 0.55 * config_.font_size_px,
         std::string(entry_of(track.outcome).failure ? entry_of(track.outcome).sign : ""),
         "text-anchor=\"middle\" font-weight=\"700\" font-size=\"" +
             px(1.5 * config_.font_size_px) + "\" fill=\"" + style.colour +
             "\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"");
  }

  void places(const View& view, const TraceWorld& world) {
    const double x = view.x(world.goal.x_m);
    const double y = view.y(world.goal.y_m);
    body_ += "<g fill=\"#ffffff\" stroke=\"#1b1f24\" stroke-width=\"1.6\">\n<circle cx=\"" +
             px(view.x(world.start.x_m)) + "\" cy=\"" + px(view.y(world.start.y_m)) +
             "\" r=\"5\"/>\n<path d=\"M" + px(x - 6) + " " + px(y) + "l6 -6l6 6l-6 6z\"/>\n</g>\n";
  }

  void scale(const View& view) {
    constexpr std::array kSpans_m{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 500.0};
    double span_m = kSpans_m.back();
    for (const double candidate : kSpans_m) {
      if (candidate * view.scale > 0.12 * config_.panel_px) {
        span_m = candidate;
        break;
      }
    }
    const double y = view.top + view.height() + 12;
    const double end = view.left + span_m * view.scale;
    body_ += "<path fill=\"none\" stroke=\"#57606a\" d=\"M" + px(view.left) + " " + px(y - 4) +
             "v4H" + px(end) + "v-4\"/>\n";
    text(end + 6, y + 2, px(span_m) + " m",
         "fill=\"#57606a\" font-size=\"" + px(0.85 * config_.font_size_px) + "\"");
  }

  // Width and height in px, scale included.
  std::pair<double, double> panel(const FigurePanel& panel, double left, double top) {
    const TraceWorld& w = panel.world;
    const auto [minimum, maximum] = extent_of(panel);
    const double side_m = std::max({maximum.x_m - minimum.x_m, maximum.y_m - minimum.y_m, 1e-9});
    const View view{left, top, config_.panel_px / side_m, minimum, maximum};
    world(view, w);
    if (config_.known && !panel.tracks.empty()) {
      known(view, panel.tracks.front().trace);
    }
    for (const FigureTrack& t : panel.tracks) {
      track(view, t);
    }
    if (panel.ends) places(view, w);
    scale(view);
    return {view.width(), view.height() + 20};
  }

  // One line per label with what became of it in each panel.
  double legend(double y) {
    const double line = 1.6 * config_.font_size_px;
    for (const std::string& label : labels_) {
      const Style style = style_of(label);
      y += line;
      const double middle = y - 0.35 * config_.font_size_px;
      body_ += "<path " + style.stroke + " d=\"M" + px(kGap) + " " + px(middle) + "h40\"/>\n";
      std::string words = label;
      for (const FigurePanel& panel : panels_) words += failures_of(label, panel);
      text(kGap + 50, y, words, "");
    }
    return y + kGap;
  }

  std::string failures_of(const std::string& label, const FigurePanel& panel) const {
    std::string words;
    for (const FigureTrack& t : panel.tracks) {
      const OutcomeEntry& ended = entry_of(t.outcome);
      if (t.label != label || !ended.failure) continue;
      words.append("; ").append(ended.sign).append(" ").append(ended.words);
      words += panels_.size() > 1 ? " in " + panel.title : "";
    }
    return words;
  }

  const std::vector<FigurePanel>& panels_;
  const FigureConfig& config_;
  std::vector<std::string> labels_;  // in the order of first use
  std::string body_;
};

}  // namespace

std::string svg_figure(const std::vector<FigurePanel>& panels, const FigureConfig& config) {
  return Figure(panels, config).draw();
}

}  // namespace voronaut
