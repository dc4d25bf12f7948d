#include "voronaut/environments/formats/blocked_cells.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

BlockedCells random_cells(Random& random, int columns, int rows, double share) {
  BlockedCells cells(columns, rows);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if (random.uniform() < share) cells.block(column, row);
  return cells;
}

TEST(BlockedCells, AreEachCoveredByExactlyOneBlock) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const int columns = 1 + static_cast<int>(random.below(20));
    const int rows = 1 + static_cast<int>(random.below(20));
    const BlockedCells cells = random_cells(random, columns, rows, random.uniform());
    BlockedCells covered(columns, rows);
    for (const CellBlock& block : blocks_of(cells)) {
      for (int row = block.row; row < block.row + block.rows; ++row) {
        for (int column = block.column; column < block.column + block.columns; ++column) {
          EXPECT_FALSE(covered.blocked(column, row)) << "covered twice";
          covered.block(column, row);
        }
      }
    }
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        ASSERT_EQ(covered.blocked(column, row), cells.blocked(column, row)) << "trial " << trial;
  }
}

TEST(BlockedCells, BecomeFewBlocks) {
  BlockedCells cells(30, 20);  // a frame of one cell around a free inside
  for (int column = 0; column < 30; ++column) {
    cells.block(column, 0);
    cells.block(column, 19);
  }
  for (int row = 0; row < 20; ++row) {
    cells.block(0, row);
    cells.block(29, row);
  }
  EXPECT_EQ(blocks_of(cells).size(), 4U);
}

// Against the cells one by one, at sizes that no double holds exactly.
TEST(BlockedCells, AsShapesHaveTheClearanceOfTheirCells) {
  Random random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const CellFrame frame{
        12, 9, random.uniform(0.03, 0.7), {random.uniform(-20, 20), random.uniform(-20, 20)}};
    const BlockedCells cells = random_cells(random, frame.columns, frame.rows, 0.3);
    const ForeignWorld read = world_of(cells, frame);
    Shapes one_by_one;
    for (int row = 0; row < frame.rows; ++row)
      for (int column = 0; column < frame.columns; ++column)
        if (cells.blocked(column, row))
          one_by_one.polygons.push_back(
              box(Bounds{frame.corner(column, row), frame.corner(column + 1, row + 1)}));
    for (int sample = 0; sample < 200; ++sample) {
      const Vec2 p(random.uniform(read.bounds->min.x(), read.bounds->max.x()),
                   random.uniform(read.bounds->min.y(), read.bounds->max.y()));
      const double expected_m = clearance_m(one_by_one, p);
      const double read_m = clearance_m(read.shapes, p);
      EXPECT_TRUE(expected_m > 0 ? std::abs(read_m - expected_m) < 1e-12 : read_m <= 0);
    }
  }
}

// Along every line of the grid, where blocks share edges and corners: whether a ray passes depends
// on the cells on both sides of the line alone.
TEST(BlockedCells, LeaveNoSeamForARayOrADisc) {
  Random random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const CellFrame frame{
        10, 10, random.uniform(0.03, 0.7), {random.uniform(-20, 20), random.uniform(-20, 20)}};
    const BlockedCells cells = random_cells(random, 10, 10, 0.4);
    const ForeignWorld read = world_of(cells, frame);
    const World world(*read.bounds, read.shapes);
    for (int line = 1; line < 10; ++line) {
      int first = 10;  // column where the line first meets a blocked cell on either side
      for (int column = 9; column >= 0; --column)
        if (cells.blocked(column, line) || cells.blocked(column, line - 1)) first = column;
      const Vec2 from = frame.corner(0, line) - Vec2(1, 0);
      const Vec2 to = frame.corner(10, line) + Vec2(1, 0);
      EXPECT_EQ(world.segment_is_clear(from, to, 1e-9), first == 10) << "row line " << line;
      if (first < 10 && first > 0) {
        EXPECT_TRUE(world.segment_is_clear(from, frame.corner(first, line) - Vec2(1e-6, 0), 1e-9));
      }
    }
    for (int line = 1; line < 10; ++line) {
      bool met = false;
      for (int row = 0; row < 10; ++row)
        met = met || cells.blocked(line, row) || cells.blocked(line - 1, row);
      EXPECT_EQ(world.segment_is_clear(frame.corner(line, 0) - Vec2(0, 1),
                                       frame.corner(line, 10) + Vec2(0, 1), 1e-9),
                !met);
    }
  }
}

TEST(BlockedCells, ThatTouchAtACornerStopADiscButNotWhatGoesAround) {
  BlockedCells cells(2, 2);
  cells.block(0, 0);
  cells.block(1, 1);
  const ForeignWorld read = world_of(cells, {2, 2, 0.1});
  const World world(*read.bounds, read.shapes);
  EXPECT_FALSE(world.segment_is_clear({-0.1, 0.3}, {0.3, -0.1}, 1e-9));
  EXPECT_NEAR(world.clearance_m({0.1, 0.1}), 0, 1e-15);
  EXPECT_GT(world.clearance_m({0.05, 0.15}), 0.04);
}

}  // namespace
}  // namespace voronaut
