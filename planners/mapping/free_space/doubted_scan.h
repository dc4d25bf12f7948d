#pragma once

#include <cstddef>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// How far off a scan and its pose may be, at most. All zero: exact.
struct SensingErrors {
  double range_m = 0;      // of a return
  double position_m = 0;   // of the range finder
  double heading_rad = 0;  // of the range finder

  bool none() const { return range_m == 0 && position_m == 0 && heading_rad == 0; }
};

// What a scan proves empty wherever the truth lies within the declared errors: the star of the scan
// (ScanStar), turned by heading_rad either way, less a rim of position_m and range_m.
//
// A point of that is empty if the disc of position_m about it, turned by heading_rad, lies within
// the true star. That disc meets what a beam of range r did not prove only from r - position_m on,
// and only within heading_rad + asin(position_m / that range) of the beam. So each beam shortens
// its neighbours within this angle, and one more, for a star is drawn between two beams.
class DoubtedScan {
 public:
  // Nothing stands nearer to the range finder than nearest_m > 0: what was not measured, beyond the
  // edges of the field of view and where a beam failed, is unknown from there on.
  DoubtedScan(const SensingErrors& errors, double nearest_m);

  // `scan` with such ranges; 0 where nothing is proved. Valid until the next call. O(beams x beams
  // within the angle above).
  const Scan& of(const Scan& scan);

 private:
  double angle_rad(double range_m) const;
  void shorten_about(std::ptrdiff_t beam, double range_m, const Scan& scan);

  SensingErrors errors_;
  double nearest_m_;
  Scan doubted_;
};

}  // namespace voronaut
