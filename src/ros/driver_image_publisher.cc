#include "rovio_sfm/ros/driver_image_publisher.h"

#include <camera_calibration_parsers/parse.h>
#include <cv_bridge/cv_bridge.h>
#include <ros/console.h>
#include <ros/service_manager.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/image_encodings.h>

#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm {
namespace {

constexpr char kSetCameraInfo[] = "set_camera_info";
constexpr std::string_view kFileScheme = "file://";

bool IsShipped(const std::string& url) { return StartsWith(url, "package://"); }

// Where image_transport's own compressed plug-in is installed it would publish a second, re-encoded
// picture on the topic of the robot's own bytes.
ros::NodeHandle WithoutPlugins(const ros::NodeHandle& handle) {
  handle.setParam(std::string(topics::kImageRaw) + "/disable_pub_plugins",
                  std::vector<std::string>{"image_transport/compressed"});
  return handle;
}

}  // namespace

DriverImagePublisher::DriverImagePublisher(const ros::NodeHandle& handle,
                                           const DriverOptions& options)
    : handle_(handle),
      frame_id_(options.frames.camera_optical),
      latency_ns_(std::llround(options.image_latency_s * 1e9)),
      transport_(WithoutPlugins(handle)),
      camera_name_(options.camera_name),
      camera_info_url_(IsShipped(options.camera_info_url) ? "" : options.camera_info_url),
      info_manager_(handle, options.camera_name, options.camera_info_url),
      compressed_(handle_.advertise<sensor_msgs::CompressedImage>(topics::kImageCompressed,
                                                                  topics::kImageQueue)),
      info_(handle_.advertise<sensor_msgs::CameraInfo>(topics::kCameraInfo,
                                                       topics::kCameraInfoQueue)),
      decoded_(transport_.advertise(topics::kImageRaw, topics::kImageQueue)) {
  LoadCalibration(options.camera_info_url, options.camera_name);
  // The manager's own service takes and keeps anything.
  ros::ServiceManager::instance()->unadvertiseService(handle_.resolveName(kSetCameraInfo));
  set_camera_info_ =
      handle_.advertiseService(kSetCameraInfo, &DriverImagePublisher::SetCameraInfo, this);
}

// A calibration that comes with a package is where a robot begins, never where one is written: that
// is $ROS_HOME/camera_info/<camera_name>.yaml, which goes before it once it is there.
void DriverImagePublisher::LoadCalibration(const std::string& url, const std::string& camera_name) {
  if (!IsShipped(url)) {
    info_manager_.loadCameraInfo(url);
    HasUsableCalibration();
    return;
  }
  info_manager_.setCameraName(std::filesystem::path(url).stem().string());  // as it names itself
  info_manager_.loadCameraInfo(url);
  const sensor_msgs::CameraInfo shipped = info_manager_.getCameraInfo();
  info_manager_.setCameraName(camera_name);
  info_manager_.loadCameraInfo("");
  if (!HasUsableCalibration()) info_manager_.setCameraInfo(shipped);
}

// Says why one that is there is of no use.
bool DriverImagePublisher::HasUsableCalibration() {
  if (!info_manager_.isCalibrated()) return false;
  std::string error;
  if (FromCameraInfo(info_manager_.getCameraInfo(), &error)) return true;
  ROS_ERROR_STREAM_NAMED("images", CalibrationFile() << ": of no use: " << error);
  return false;
}

std::string DriverImagePublisher::CalibrationFile() {
  const std::string url = info_manager_.resolveURL(
      camera_info_url_.empty() ? "file://${ROS_HOME}/camera_info/${NAME}.yaml" : camera_info_url_,
      camera_name_);
  return StartsWith(url, kFileScheme) ? url.substr(kFileScheme.size()) : url;
}

bool DriverImagePublisher::SetCameraInfo(sensor_msgs::SetCameraInfo::Request& request,
                                         sensor_msgs::SetCameraInfo::Response& response) {
  response.success = false;
  if (!FromCameraInfo(request.camera_info, &response.status_message)) return true;
  const std::string file = CalibrationFile();
  std::error_code ignored;  // the writer fails then
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(), ignored);
  if (!camera_calibration_parsers::writeCalibration(file, camera_name_, request.camera_info)) {
    response.status_message = file + ": cannot be written";
    return true;
  }
  info_manager_.setCameraInfo(request.camera_info);
  response.success = true;
  response.status_message = "wrote " + file;
  return true;
}

void DriverImagePublisher::Publish(const CameraImage& image) {
  if (image.stamp_ns <= latency_ns_) return DropWithoutTime();
  std_msgs::Header header;
  header.stamp = ToTime(image.stamp_ns - latency_ns_);
  header.frame_id = frame_id_;

  sensor_msgs::CameraInfo info = InfoFor(image);
  info.header = header;
  sensor_msgs::CompressedImagePtr message(new sensor_msgs::CompressedImage);
  message->header = header;
  message->format = "jpeg";
  message->data.assign(image.jpeg.begin(), image.jpeg.end());
  info_.publish(info);  // first: a receiver needs the camera to use the image
  compressed_.publish(message);
  if (decoded_.getNumSubscribers() > 0) PublishDecoded(image, header);
  ++num_published_;
}

void DriverImagePublisher::DropWithoutTime() {
  ++num_without_time_;
  if (has_warned_of_time_) return;
  has_warned_of_time_ = true;
  ROS_WARN_NAMED("images",
                 "images are dropped: there is no time yet (/use_sim_time is set and "
                 "nobody publishes /clock)");
}

bool DriverImagePublisher::HasListeners() const {
  return compressed_.getNumSubscribers() + decoded_.getNumSubscribers() > 0;
}

// An image of another size than the calibration's is published as uncalibrated: nobody knows
// whether the sensor scales or crops.
sensor_msgs::CameraInfo DriverImagePublisher::InfoFor(const CameraImage& image) {
  sensor_msgs::CameraInfo info = info_manager_.getCameraInfo();
  const auto width = static_cast<uint32_t>(image.width_px);
  const auto height = static_cast<uint32_t>(image.height_px);
  const bool fits = info.width == width && info.height == height;
  is_calibrated_ = fits && info.K[0] != 0.0;
  if (fits) return info;
  if (!has_warned_of_size_) {
    ROS_WARN_NAMED("images", "images are %u x %u, the calibration is for %u x %u: uncalibrated",
                   width, height, info.width, info.height);
    has_warned_of_size_ = true;
  }
  info = sensor_msgs::CameraInfo();
  info.width = width;
  info.height = height;
  return info;
}

void DriverImagePublisher::PublishDecoded(const CameraImage& image,
                                          const std_msgs::Header& header) {
  const std::vector<uint8_t> bytes(image.jpeg.begin(), image.jpeg.end());
  const cv::Mat pixels = cv::imdecode(bytes, cv::IMREAD_COLOR);
  if (pixels.empty()) return;
  decoded_.publish(
      cv_bridge::CvImage(header, sensor_msgs::image_encodings::BGR8, pixels).toImageMsg());
}

}  // namespace rovio_sfm
