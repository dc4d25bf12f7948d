#pragma once

namespace voronaut {

// What happens otherwise than the vehicle is modelled and its pose is told. By default nothing.
struct DisturbanceConfig {
  double latency_s = 0;
  double gain_error = 0;
  double position_sigma_m = 0;
  double heading_sigma_rad = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("latency_s", latency_s, 0, 1, "Commands act so much later, in whole vehicle steps");
    v.number("gain_error", gain_error, 0, 0.9,
             "What is commanded is more or less by this share, each of a command's numbers by a "
             "sign of its own, drawn once a trial");
    v.number("position_sigma_m", position_sigma_m, 0, 10,
             "Standard deviation of Gaussian noise on x and y of the pose told, each vehicle step");
    v.number("heading_sigma_rad", heading_sigma_rad, 0, 0.5, "The same of its heading");
  }
};

}  // namespace voronaut
