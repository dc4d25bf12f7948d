#include "voronaut/benchmarks/episode/search_trace.h"

#include <set>

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"

namespace voronaut {
namespace {

using Ends = std::array<double, 4>;

Ends sorted(const TracePoint& a, const TracePoint& b) {
  const Ends forth{a.x_m, a.y_m, b.x_m, b.y_m};
  return std::min(forth, Ends{b.x_m, b.y_m, a.x_m, a.y_m});
}

std::set<Ends> kept(const Trace& trace, int search) {
  std::set<Ends> edges;
  for (const TraceEdge& edge : trace.edges) {
    if (edge.first_search <= search && search <= edge.last_search) {
      EXPECT_TRUE(edges.insert(sorted(edge.a, edge.b)).second) << "told twice";
    }
  }
  return edges;
}

// On a small lattice, so that searches share edges, turned ones too.
std::vector<std::vector<Segment>> random_searches(std::uint64_t seed) {
  Random random(seed);
  const auto place = [&] { return 0.25 * std::floor(random.uniform() * 4); };
  std::vector<std::vector<Segment>> searches(20);
  for (auto& search : searches) {
    for (int i = 0; i < 15; ++i) search.push_back({{place(), place()}, {place(), place()}});
  }
  return searches;
}

Trace trace_of(const std::vector<std::vector<Segment>>& searches,
               std::size_t most_edges = kMostTraceEdges) {
  SearchHistory history(most_edges);
  for (const auto& search : searches) history.add(search);
  Trace trace;
  history.write_to(trace);
  return trace;
}

TEST(SearchTrace, EverySearchReadsBackWhole) {
  const auto searches = random_searches(1);
  const Trace trace = trace_of(searches);
  EXPECT_EQ(trace.searches, 20);
  EXPECT_EQ(trace.kept_searches, 20);
  std::size_t told = 0;
  for (std::size_t s = 0; s < searches.size(); ++s) {
    std::set<Ends> expected;
    for (const Segment& edge : searches[s]) {
      expected.insert(sorted({edge.a.x(), edge.a.y()}, {edge.b.x(), edge.b.y()}));
    }
    told += expected.size();
    EXPECT_EQ(kept(trace, static_cast<int>(s)), expected) << s;
  }
  EXPECT_LT(trace.edges.size(), told) << "nothing was shared between searches";
}

TEST(SearchTrace, WhatHasNoRoomIsLeftOutFromASearchOn) {
  const auto searches = random_searches(2);
  const Trace whole = trace_of(searches);
  const Trace trace = trace_of(searches, 60);
  EXPECT_EQ(trace.searches, 20);
  ASSERT_GT(trace.kept_searches, 0);
  ASSERT_LT(trace.kept_searches, 20);
  EXPECT_LE(trace.edges.size(), 60U);
  for (int s = 0; s < trace.kept_searches; ++s) EXPECT_EQ(kept(trace, s), kept(whole, s));
  for (const TraceEdge& edge : trace.edges) EXPECT_LT(edge.last_search, trace.kept_searches);
}

TEST(SearchTrace, IsFullWithTheFirstSearchThatHasNoRoomAndOnlyCountsFromThen) {
  SearchHistory history(60);
  std::vector<Segment> huge(100'000);
  for (std::size_t i = 0; i < huge.size(); ++i)
    huge[i] = {{0, 0}, {1, 0.01 * static_cast<double>(i)}};
  history.add(std::span(huge).first(10));
  EXPECT_FALSE(history.full());
  history.add(huge);
  EXPECT_TRUE(history.full());
  history.add({});
  Trace trace;
  history.write_to(trace);
  EXPECT_EQ(trace.searches, 3);
  EXPECT_EQ(trace.kept_searches, 1);
  EXPECT_EQ(trace.edges.size(), 10U);
}

}  // namespace
}  // namespace voronaut
