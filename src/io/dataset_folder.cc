#include "rovio_sfm/io/dataset_folder.h"

#include <stdexcept>
#include <utility>

#include "rovio_sfm/io/calibration.h"
#include "rovio_sfm/io/odometry_file.h"
#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMaxOdometryGapNs = 1'000'000'000;
constexpr int64_t kMaxLateNs = 1'000'000'000;

// times.txt may name only files below its own folder.
void RequireInside(const TextLine& line, const std::filesystem::path& name) {
  const std::filesystem::path normal = name.lexically_normal();
  if (normal.is_absolute() || normal.empty() || *normal.begin() == "..") {
    line.Fail("field filename: expected a path below the folder, got '" + name.string() + "'");
  }
}

// A link may lead nowhere, or round in a circle. Empty: it is a file.
std::string WhyNoFile(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::is_regular_file(status)) return "";
  if (std::filesystem::exists(status)) return "no file, but something else:";
  const bool is_missing = status.type() == std::filesystem::file_type::not_found;
  return is_missing ? "no such file" : error.message() + ":";
}

// The name is the rest of the line: it may hold blanks.
DatasetImage ParseImage(const TextLine& line, const std::filesystem::path& folder) {
  if (line.fields.size() < 2) line.RequireFields(2, "timestamp filename");
  DatasetImage image;
  image.stamp_ns = line.Stamp(0, "timestamp");
  image.name = line.From(1);
  RequireInside(line, image.name);
  image.path = folder / image.name;
  const std::string reason = WhyNoFile(image.path);
  if (!reason.empty()) line.Fail("field filename: " + reason + " " + image.path.string());
  return image;
}

// True for an image that comes no more than a second late: it alone is left out.
bool IsLate(const TextLine& line, int64_t stamp_ns, int64_t last_ns) {
  if (stamp_ns > last_ns) return false;
  if (last_ns - stamp_ns > kMaxLateNs) {
    line.Fail("field timestamp: more than 1 s before that of the line before");
  }
  return true;
}

void TellLate(const std::vector<TextLine>& late, bool has_overlaps) {
  if (late.empty()) return;
  const std::string reason = "field timestamp: expected a later one than the line before";
  if (has_overlaps) late.front().Fail(reason + ", as overlaps.txt numbers the images");
  LogWarning(late.front().file + ": " + CountText(late.size(), "image") +
             " left out, the first in line " + std::to_string(late.front().number) + ": " + reason);
}

std::vector<DatasetImage> ReadImageList(const std::filesystem::path& folder) {
  std::vector<DatasetImage> images;
  std::vector<TextLine> late;
  for (const TextLine& line : ReadTextFile(folder / "times.txt")) {
    DatasetImage image = ParseImage(line, folder);
    if (!images.empty() && IsLate(line, image.stamp_ns, images.back().stamp_ns)) {
      late.push_back(line);
    } else {
      images.push_back(std::move(image));
    }
  }
  if (images.empty()) throw std::runtime_error((folder / "times.txt").string() + ": no images");
  TellLate(late, std::filesystem::exists(folder / "overlaps.txt"));
  return images;
}

void AttachOdometry(const std::filesystem::path& file, std::vector<DatasetImage>* images) {
  if (!std::filesystem::exists(file)) return;
  const std::vector<StampedOdometry> odometry = ReadOdometry(file);
  for (DatasetImage& image : *images) {
    image.odometry = InterpolateOdometry(odometry, image.stamp_ns, kMaxOdometryGapNs);
  }
}

// A single line says that the head does not move.
void AttachExtrinsics(const std::filesystem::path& file, std::vector<DatasetImage>* images) {
  if (!std::filesystem::exists(file)) return;
  const std::vector<StampedPose> extrinsics = ReadTrajectory(file);
  for (DatasetImage& image : *images) {
    image.base_from_camera = extrinsics.size() == 1
                                 ? std::optional<Rigid3>(extrinsics.front().reference_from_body)
                                 : InterpolatePose(extrinsics, image.stamp_ns, kMaxOdometryGapNs);
  }
}

uint32_t ImageIndex(const TextLine& line, size_t field, const char* name, size_t num_images) {
  const double index = line.Number(field, name);
  if (!(index >= 0.0) || index >= static_cast<double>(num_images)) {
    line.Fail(std::string("field ") + name + ": expected an image of 0 to " +
              std::to_string(num_images - 1) + ", got '" + line.fields[field] + "'");
  }
  return static_cast<uint32_t>(index);
}

std::vector<DatasetOverlap> ReadOverlaps(const std::filesystem::path& file, size_t num_images) {
  std::vector<DatasetOverlap> overlaps;
  if (!std::filesystem::exists(file)) return overlaps;
  for (const TextLine& line : ReadTextFile(file)) {
    line.RequireFields(4, "frame_i frame_j share angle_deg");
    overlaps.push_back({ImageIndex(line, 0, "frame_i", num_images),
                        ImageIndex(line, 1, "frame_j", num_images), line.Number(2, "share"),
                        line.Number(3, "angle_deg")});
  }
  return overlaps;
}

}  // namespace

DatasetFolder ReadDatasetFolder(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) {
    throw std::runtime_error(path.string() + ": no such folder");
  }
  DatasetFolder dataset;
  dataset.path = path;
  dataset.camera = ReadCalibrationText(path / "calibration.txt");
  dataset.images = ReadImageList(path);
  AttachOdometry(path / "odometry.txt", &dataset.images);
  AttachExtrinsics(path / "extrinsics.txt", &dataset.images);
  if (std::filesystem::exists(path / "groundtruth.txt")) {
    dataset.ground_truth = ReadTrajectory(path / "groundtruth.txt");
  }
  dataset.overlaps = ReadOverlaps(path / "overlaps.txt", dataset.images.size());
  return dataset;
}

DatasetFolder EveryNth(const DatasetFolder& dataset, size_t stride) {
  DatasetFolder thinned = dataset;
  thinned.images.clear();
  thinned.overlaps.clear();
  for (size_t i = 0; i < dataset.images.size(); i += stride) {
    thinned.images.push_back(dataset.images[i]);
  }
  for (const DatasetOverlap& overlap : dataset.overlaps) {
    if (overlap.image_a % stride != 0 || overlap.image_b % stride != 0) continue;
    thinned.overlaps.push_back(overlap);
    thinned.overlaps.back().image_a /= static_cast<uint32_t>(stride);
    thinned.overlaps.back().image_b /= static_cast<uint32_t>(stride);
  }
  return thinned;
}

}  // namespace rovio_sfm
