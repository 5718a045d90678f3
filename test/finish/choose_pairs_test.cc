#include "rovio_sfm/finish/choose_pairs.h"

#include <gtest/gtest.h>

#include "finish/small_model.h"

namespace rovio_sfm {
namespace {

using Images = std::vector<uint32_t>;

// Two drives of so many images each.
MapModel TwoDrives(int num_images) {
  MapModel model = SmallRoom(2 * num_images);
  for (int i = num_images; i < 2 * num_images; ++i) {
    model.images[static_cast<size_t>(i)].id = {{"rovio2", 1, 1},
                                               static_cast<uint32_t>(i - num_images)};
  }
  return model;
}

TEST(ChoosePairs, TakesThePredecessorsTheNearestFirst) {
  PairChoiceOptions options;
  options.max_predecessors = 2;
  options.max_overlaps = 0;
  EXPECT_EQ(ChoosePairs(SmallRoom(4), options), (std::vector<Images>{{}, {0}, {1, 0}, {2, 1}}));
}

TEST(ChoosePairs, NeverTakesAnotherDrivesImageForAPredecessor) {
  PairChoiceOptions options;
  options.max_overlaps = 0;
  EXPECT_EQ(ChoosePairs(TwoDrives(2), options), (std::vector<Images>{{}, {0}, {}, {2}}));
}

// Algorithm 3: the overlap I_s is matched with the predecessors of I_q, and I_q with it.
TEST(ChoosePairs, TakesOverlapsWithThePredecessorsToo) {
  MapModel model = TwoDrives(2);
  for (ModelPoint& point : model.points) point.views = {{1, 0}, {3, 0}};
  PairChoiceOptions options;
  EXPECT_EQ(ChoosePairs(model, options), (std::vector<Images>{{}, {0}, {1}, {2, 1}}));
  options.min_common = model.points.size() + 1;
  EXPECT_EQ(ChoosePairs(model, options), (std::vector<Images>{{}, {0}, {}, {2}}));
}

TEST(ChoosePairs, TakesTheOverlapsThatShareMost) {
  MapModel model = TwoDrives(3);
  for (size_t i = 0; i < model.points.size(); ++i) {
    model.points[i].views = {{i % 3 == 0 ? 0u : 1u, 0}, {5, 0}};
  }
  PairChoiceOptions options;
  options.max_predecessors = 0;
  options.max_overlaps = 1;
  EXPECT_EQ(ChoosePairs(model, options).back(), (Images{1}));
}

}  // namespace
}  // namespace rovio_sfm
