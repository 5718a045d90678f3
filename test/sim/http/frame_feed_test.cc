#include "rovio_sfm/sim/http/frame_feed.h"

#include <gtest/gtest.h>

#include <thread>

namespace rovio_sfm::sim {
namespace {

using std::chrono::milliseconds;

TEST(FrameFeed, WaitEndsWithANewerPicture) {
  FrameFeed feed;
  std::optional<Picture> seen;
  std::thread client([&] { seen = feed.WaitForNewer(0, std::chrono::hours(1)); });
  EXPECT_TRUE(feed.WaitForDemand());
  feed.Publish(feed.BeginCapture(), {1, 2});
  client.join();
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->number, 1u);
  EXPECT_EQ(*seen->jpeg, (std::vector<uint8_t>{1, 2}));
}

TEST(FrameFeed, PictureBegunBeforeTheRequestIsNotFresh) {
  FrameFeed feed;
  const uint64_t early = feed.BeginCapture();
  const uint64_t begun = feed.LastBegun();
  feed.Publish(early, {1});
  EXPECT_FALSE(feed.WaitForNewer(begun, milliseconds(0)));
  feed.Publish(feed.BeginCapture(), {2});
  EXPECT_TRUE(feed.WaitForNewer(begun, milliseconds(0)));
}

TEST(FrameFeed, CloseEndsAllWaits) {
  FrameFeed feed;
  std::optional<Picture> seen;
  std::thread client([&] { seen = feed.WaitForNewer(0, std::chrono::hours(1)); });
  EXPECT_TRUE(feed.WaitForDemand());
  feed.Close();
  client.join();
  EXPECT_FALSE(seen);
  EXPECT_FALSE(feed.WaitForDemand());
  EXPECT_TRUE(feed.IsClosed());
}

}  // namespace
}  // namespace rovio_sfm::sim
