#include "rovio_sfm/ros/bag_topics.h"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// A bag with an empty message on each topic.
class BagTopicsTest : public testing::Test {
 protected:
  std::filesystem::path Write(const std::vector<std::string>& image_topics) {
    const std::filesystem::path path = folder_.Path() / "a.bag";
    rosbag::Bag bag(path.string(), rosbag::bagmode::Write);
    for (const std::string& topic : image_topics) {
      if (topic.find("/compressed") != std::string::npos) {
        bag.write(topic, ros::Time(1), sensor_msgs::CompressedImage());
      } else {
        bag.write(topic, ros::Time(1), sensor_msgs::Image());
      }
    }
    bag.write("/left/camera_info", ros::Time(1), sensor_msgs::CameraInfo());
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(BagTopicsTest, FindsEachRobotAndPrefersCompressedImages) {
  const auto path = Write({"/b/image_raw", "/a/image_raw", "/a/image_raw/compressed", "/c/other"});
  const std::vector<BagDrive> drives = FindDrives({path});
  ASSERT_EQ(drives.size(), 2u);
  EXPECT_EQ(drives[0].robot, "a");
  EXPECT_EQ(drives[0].image_topic, "/a/image_raw/compressed");
  EXPECT_EQ(drives[0].info_topic, "/a/camera_info");
  EXPECT_EQ(drives[0].odom_topic, "/a/odom");
  EXPECT_EQ(drives[1].image_topic, "/b/image_raw");
}

TEST_F(BagTopicsTest, TakesTheTopicThatWasAskedFor) {
  const auto path = Write({"/Robot-1/color/image_raw/compressed"});
  for (const char* name : {"/Robot-1/color/image_raw", "Robot-1/color/image_raw",
                           "/Robot-1/color/image_raw/compressed"}) {
    const std::vector<BagDrive> drives = FindDrives({path}, {name, "", ""});
    ASSERT_EQ(drives.size(), 1u);
    EXPECT_EQ(drives[0].robot, "robot_1");
    EXPECT_EQ(drives[0].image_topic, "/Robot-1/color/image_raw/compressed");
    EXPECT_EQ(drives[0].info_topic, "/Robot-1/color/camera_info");
    EXPECT_EQ(drives[0].odom_topic, "/Robot-1/odom");
  }
  const auto drives = FindDrives({path}, {"/Robot-1/color/image_raw", "/left/camera_info", "/o"});
  EXPECT_EQ(drives[0].info_topic, "/left/camera_info");
  EXPECT_EQ(drives[0].odom_topic, "/o");
}

TEST_F(BagTopicsTest, ListsTheImagesWhereTheNameIsAnother) {
  const auto path = Write({"/Robot1/image_raw", "/camera/color/image_raw/compressed"});
  for (const BagTopics& topics : {BagTopics(), BagTopics{"/front/image", "", ""}}) {
    const std::string message = MessageOf([&] { FindDrives({path}, topics); });
    EXPECT_NE(message.find("/Robot1/image_raw, /camera/color/image_raw/compressed"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("--image-topic"), std::string::npos) << message;
  }
}

TEST_F(BagTopicsTest, NamesWhatIsNoWholeBag) {
  const std::string whole = ReadText(Write({"/a/image_raw"}));
  const std::string folder = folder_.Path().string();
  for (const auto& [name, bytes] :
       {std::pair<std::string, std::string>{"text.bag", "no bag at all"},
        {"empty.bag", ""},
        {"head.bag", whole.substr(0, 20)},
        {"cut.bag", whole.substr(0, whole.size() - 30)},
        {"half.bag", whole.substr(0, whole.size() / 2)}}) {
    const std::filesystem::path path = folder_.Write(name, bytes);
    const std::string message = MessageOf([&, path = path] { FindDrives({path}); });
    EXPECT_EQ(message.find(path.string() + ": no bag, or not a whole one: "), 0u) << message;
  }
  EXPECT_EQ(MessageOf([&] { FindDrives({folder}); }), folder + ": is a folder; expected a bag");
  EXPECT_EQ(MessageOf([&] { FindDrives({folder + "/none.bag"}); }),
            folder + "/none.bag: no such file");
}

// As a recorder that was killed leaves it: no index yet, and the header says so.
TEST_F(BagTopicsTest, SaysWhatMendsABagThatWasNotClosed) {
  const std::filesystem::path path = folder_.Path() / "killed.bag";
  rosbag::Bag bag(path.string(), rosbag::bagmode::Write);
  bag.write("/a/image_raw", ros::Time(1), sensor_msgs::Image());
  const std::filesystem::path copy = folder_.Path() / "copy.bag";
  std::filesystem::copy_file(path, copy);
  const std::string message = MessageOf([&] { FindDrives({copy}); });
  EXPECT_NE(message.find("rosbag reindex " + copy.string()), std::string::npos) << message;
}

}  // namespace
}  // namespace rovio_sfm
