#include "voronaut/reports/summary/summary.h"

#include "voronaut/reports/summary/summary_table.h"

namespace voronaut {

const Estimate& PlannerSummary::of(std::string_view name) const {
  return estimates.at(static_cast<std::size_t>(&statistic(name) - statistics().data()));
}

Summary summarise(const std::vector<RunRecord>& records, const SummaryConfig& config) {
  SummaryTable table;
  for (const RunRecord& record : records) table.add(record);
  return table.summarise(config);
}

}  // namespace voronaut
