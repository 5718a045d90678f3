#include "rovio_sfm/ros/images_to_bag.h"

#include <rosbag/bag.h>
#include <sensor_msgs/CompressedImage.h>
#include <tf2_msgs/TFMessage.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>

#include "rovio_sfm/app/output_folder.h"
#include "rovio_sfm/io/odometry_file.h"
#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/parse_arguments.h"
#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kFirstStampNs = 1;
constexpr uintmax_t kMaxImageBytes = 64u << 20;
constexpr uintmax_t kBytesBesideImage = 4096;  // camera_info, tf, odometry, index

// ROS takes zero for no stamp, and none before it: what begins at zero begins a nanosecond later.
int64_t RosStamp(int64_t stamp_ns) {
  if (stamp_ns >= 0) return std::max(kFirstStampNs, stamp_ns);
  throw std::runtime_error("stamp " + DecimalFromStamp(stamp_ns) + " s: ROS has none before zero");
}

// Writes the messages of one robot, and leaves nothing behind unless closed.
class BagWriter {
 public:
  BagWriter(const std::string& robot, const std::filesystem::path& path)
      : robot_(robot), path_(path), bag_(std::make_unique<rosbag::Bag>()) {
    bag_->open(path.string(), rosbag::bagmode::Write);
  }
  // Where nothing more can be written rosbag's own destructor throws, which ends the program.
  ~BagWriter() {
    if (!bag_) return;
    try {
      bag_->close();
    } catch (const std::exception&) {
      static_cast<void>(bag_.release());
    }
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  void WriteImage(const DatasetImage& image, const Camera& camera) {
    sensor_msgs::CompressedImage message;
    const int64_t stamp_ns = RosStamp(image.stamp_ns);
    message.header.stamp = ToTime(stamp_ns);
    message.header.frame_id = robot_ + "/camera_optical";
    message.data = ReadBytes(image.path, kMaxImageBytes);
    if (message.data.empty()) throw std::runtime_error(image.path.string() + ": empty");
    message.format = message.data.front() == 0xFF ? "jpeg" : "png";
    bag_->write(Topic(topics::kCameraInfo), message.header.stamp,
                ToCameraInfo(camera, stamp_ns, message.header.frame_id));
    if (image.base_from_camera) {
      std_msgs::Header base = message.header;
      base.frame_id = robot_ + "/base_link";
      WriteTransform(base, message.header.frame_id, *image.base_from_camera, base.stamp);
    }
    bag_->write(Topic(topics::kImageCompressed), message.header.stamp, message);
  }

  void WriteOdometry(const StampedOdometry& odometry) {
    const int64_t stamp_ns = RosStamp(odometry.stamp_ns);
    bag_->write(Topic(topics::kOdom), ToTime(stamp_ns),
                ToOdometry(odometry.sample, stamp_ns, robot_ + "/odom", robot_ + "/base_link"));
  }

  void Close() {
    bag_->close();
    bag_.reset();
  }

 private:
  std::string Topic(const char* name) const { return "/" + robot_ + "/" + name; }

  void WriteTransform(const std_msgs::Header& parent, const std::string& child,
                      const Rigid3& parent_from_child, const ros::Time& time) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    message.transforms[0].header = parent;
    message.transforms[0].child_frame_id = child;
    message.transforms[0].transform = ToTransform(parent_from_child);
    bag_->write("/tf", time, message);
  }

  std::string robot_;
  std::filesystem::path path_;
  std::unique_ptr<rosbag::Bag> bag_;  // null: closed
};

std::vector<StampedOdometry> ReadAllOdometry(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "odometry.txt";
  return std::filesystem::exists(file) ? ReadOdometry(file) : std::vector<StampedOdometry>{};
}

// Images and odometry by rising stamp; odometry first where both are equal. The number of images
// written; fewer where a signal came.
size_t WriteInOrder(const DatasetFolder& dataset, BagWriter* writer) {
  const std::vector<StampedOdometry> odometry = ReadAllOdometry(dataset.path);
  auto next = odometry.begin();
  size_t num_written = 0;
  for (const DatasetImage& image : dataset.images) {
    if (IsStopRequested()) return num_written;
    for (; next != odometry.end() && next->stamp_ns <= image.stamp_ns; ++next) {
      writer->WriteOdometry(*next);
    }
    writer->WriteImage(image, dataset.camera);
    ++num_written;
  }
  for (; next != odometry.end(); ++next) writer->WriteOdometry(*next);
  return num_written;
}

uintmax_t SizeOfImages(const DatasetFolder& dataset) {
  uintmax_t size = 0;
  for (const DatasetImage& image : dataset.images) size += std::filesystem::file_size(image.path);
  return size;
}

void RequireRoomForBag(const DatasetFolder& dataset, const std::filesystem::path& bag) {
  const std::filesystem::path folder = std::filesystem::absolute(bag).parent_path();
  RequireWritableFolder(folder, SizeOfImages(dataset) + dataset.images.size() * kBytesBesideImage);
}

}  // namespace

size_t WriteBag(const DatasetFolder& dataset, const std::string& robot,
                const std::filesystem::path& bag_path, bool overwrite) {
  std::string error;
  if (!IsValidRobotName(robot, &error)) throw std::runtime_error(error);
  if (!overwrite && std::filesystem::exists(bag_path)) {
    throw std::runtime_error(bag_path.string() + ": exists already (--overwrite replaces it)");
  }
  RequireRoomForBag(dataset, bag_path);
  const std::filesystem::path unfinished = bag_path.string() + ".active";
  size_t num_written = 0;
  errno = 0;
  try {
    BagWriter writer(robot, unfinished);
    num_written = WriteInOrder(dataset, &writer);
    const HoldSecondStop hold;
    writer.Close();
    std::filesystem::rename(unfinished, bag_path);
  } catch (const rosbag::BagException& problem) {
    throw std::runtime_error(bag_path.string() + ": not written: " + problem.what() +
                             (errno == 0 ? "" : std::string(" (") + std::strerror(errno) + ")"));
  }
  return num_written;
}

int ImagesToBagCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Writes a folder of images (layout: see README) as a bag of one robot's drive");
  std::string folder, bag, robot = "rovio1";
  size_t stride = 1, max_images = 0;
  bool overwrite = false;
  app.add_option("folder", folder, "images/, times.txt, calibration.txt and so on")->required();
  app.add_option("bag", bag, "the file to write")->required();
  app.add_option("--robot", robot, "name of the robot and its namespace");
  app.add_option("--stride", stride, "every how manieth image")->check(CLI::Range(1, 1000000));
  app.add_option("--max-images", max_images, "stop after so many; 0: all");
  app.add_flag("--overwrite", overwrite, "replace the bag if it exists");
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  DatasetFolder dataset = EveryNth(ReadDatasetFolder(folder), stride);
  if (max_images > 0 && dataset.images.size() > max_images) dataset.images.resize(max_images);
  const size_t num_written = WriteBag(dataset, robot, bag, overwrite);
  out << CountText(num_written, "image") << " in " << std::filesystem::absolute(bag).string()
      << "\n";
  if (!IsStopRequested()) return 0;
  out << "stopped by a signal: " << num_written << " of "
      << CountWere(dataset.images.size(), "image") << " put into the bag\n";
  return StatusOfStop();
}

}  // namespace rovio_sfm
