#include "voronaut/reports/record_columns.h"

#include <set>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(RecordColumns, NameEveryMemberOnceAndSayWhatItIs) {
  std::set<std::string_view> names;
  std::size_t bytes = 0;
  for (const RecordColumn& column : record_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_EQ(&column_of(column.member), &column) << column.name;
    EXPECT_FALSE(column.about.empty()) << column.name;
  }
  RunRecord record;
  visit_columns(record, [&](const RecordColumn&, const auto& value) {
    bytes += std::max(sizeof value, alignof(std::string));
  });
  EXPECT_EQ(bytes, sizeof(RunRecord)) << "a member is not in the list";
}

TEST(RecordColumns, EndInTheirUnit) {
  for (const RecordColumn& column : record_columns()) {
    std::string ending(column.unit == "\u00b5s" ? "us" : column.unit);
    if (ending.empty()) continue;
    for (char& c : ending) c = c == '/' ? '_' : static_cast<char>(std::tolower(c));
    EXPECT_NE(std::string(column.name).find("_" + ending), std::string::npos) << column.name;
  }
}

}  // namespace
}  // namespace voronaut
