#pragma once

#include <cstdint>
#include <vector>

#include "voronaut/reports/summary/estimate.h"

// Is a difference chance? Pure functions; the same input gives the same bits.
namespace voronaut {

// Two-sided exact test of McNemar (Psychometrika 12, 1947, doi:10.1007/BF02295996): how probable
// are `gained` and `lost` of the pairs that differ, or a split as uneven, if each is as likely to
// be one as the other. 1 for no such pair. O(gained + lost).
double mcnemar_exact(std::int64_t gained, std::int64_t lost);

// (gained - lost) / n with its 95 % interval: Newcombe's for paired shares (Stat. Med. 17, 1998,
// method 10, doi:10.1002/(SICI)1097-0258(19981130)17:22<2635::AID-SIM954>3.0.CO;2-C), which is not
// of zero width where nothing differs. `both`: pairs that succeeded twice.
Estimate paired_share_difference(std::int64_t both, std::int64_t gained, std::int64_t lost,
                                 std::int64_t n);

// Holm's step-down correction (Scand. J. Stat. 6, 1979, pp. 65-70): p values for which the chance
// of any false alarm in the family is at most the level. NaN stays and does not count.
std::vector<double> holm_corrected(const std::vector<double>& p_values);

// Pairs of which 80 % of runs see a true difference of `tolerance` at the 5 % level; NaN where
// nothing says how the pairs scatter. The first from the share of pairs that differ (Connor,
// Biometrics 43, 1987, doi:10.2307/2531961), the second from an interval over n pairs.
double pairs_needed_of_share(double differing_share, double tolerance);
double pairs_needed(const Estimate& difference, double tolerance);

}  // namespace voronaut
