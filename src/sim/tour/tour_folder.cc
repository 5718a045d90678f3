#include "rovio_sfm/sim/tour/tour_folder.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm::sim {
namespace {

std::string ImageName(size_t index) {
  char name[32];
  std::snprintf(name, sizeof(name), "images/%06zu.jpg", index);
  return name;
}

void WriteBytes(const std::string& path, const char* data, size_t size) {
  std::ofstream file(path, std::ios::binary);
  file.write(data, static_cast<std::streamsize>(size));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

std::ostringstream TextStream(const std::string& comment, int digits) {
  std::ostringstream out;
  out << "# " << comment << "\n" << std::fixed << std::setprecision(digits);
  return out;
}

void AppendPose(double time_s, const Rigid3& pose, std::ostringstream* out) {
  const Eigen::Vector3d& t = pose.translation;
  const Eigen::Quaterniond& q = pose.rotation;
  *out << time_s << ' ' << t.x() << ' ' << t.y() << ' ' << t.z() << ' ' << q.x() << ' ' << q.y()
       << ' ' << q.z() << ' ' << q.w() << '\n';
}

}  // namespace

TourFolder::TourFolder(const std::string& path, bool overwrite) : path_(path) {
  if (!overwrite && std::filesystem::exists(path + "/times.txt")) {
    throw std::runtime_error(path + ": holds a data set already; overwrite was not asked for");
  }
  std::error_code error;
  std::filesystem::create_directories(path + "/images", error);
  if (error) throw std::runtime_error(path + "/images: " + error.message());
}

void TourFolder::WriteImage(size_t index, const std::vector<uint8_t>& jpeg) const {
  WriteBytes(path_ + "/" + ImageName(index), reinterpret_cast<const char*>(jpeg.data()),
             jpeg.size());
}

void TourFolder::WriteText(const std::string& name, const std::string& text) const {
  WriteBytes(path_ + "/" + name, text.data(), text.size());
}

void TourFolder::WriteFrames(const SimulatedTour& tour) const {
  std::ostringstream times = TextStream("timestamp filename", 6);
  std::ostringstream truth = TextStream("timestamp tx ty tz qx qy qz qw (camera to world, m)", 9);
  std::ostringstream head = TextStream("timestamp tx ty tz qx qy qz qw (base_from_camera, m)", 9);
  std::ostringstream odometry =
      TextStream("timestamp x y theta (odom_from_base, m and rad), covariance by rows", 9);
  for (size_t i = 0; i < tour.frames.size(); ++i) {
    const TourFrame& frame = tour.frames[i];
    times << frame.time_s << ' ' << ImageName(i) << '\n';
    AppendPose(frame.time_s, frame.world_from_camera, &truth);
    AppendPose(frame.time_s, tour.base_from_camera, &head);
    odometry << frame.time_s << ' ' << frame.odometry.x() << ' ' << frame.odometry.y() << ' '
             << frame.odometry.z();
    for (int k = 0; k < 9; ++k) odometry << ' ' << frame.odometry_covariance(k / 3, k % 3);
    odometry << '\n';
  }
  WriteText("groundtruth.txt", truth.str());
  WriteText("extrinsics.txt", head.str());
  WriteText("odometry.txt", odometry.str());
  WriteText("times.txt", times.str());
}

void TourFolder::WriteCalibration(const std::string& name, const Camera& camera) const {
  std::ostringstream out =
      TextStream("fx fy cx cy k1 k2 p1 p2 k3 width height (OpenCV plumb-bob model)", 6);
  out << camera.fx << ' ' << camera.fy << ' ' << camera.cx << ' ' << camera.cy << ' ' << camera.k1
      << ' ' << camera.k2 << ' ' << camera.p1 << ' ' << camera.p2 << ' ' << camera.k3 << ' '
      << camera.width << ' ' << camera.height << '\n';
  WriteText(name, out.str());
}

void TourFolder::WriteOverlaps(const std::string& name,
                               const std::vector<ViewOverlap>& overlaps) const {
  std::ostringstream out =
      TextStream("frame_i frame_j share of pixels covisible, angle in degrees", 4);
  for (const ViewOverlap& overlap : overlaps) {
    out << overlap.first << ' ' << overlap.second << ' ' << overlap.covisible_share << ' '
        << Degrees(overlap.angle_rad) << '\n';
  }
  WriteText(name, out.str());
}

}  // namespace rovio_sfm::sim
