#include "rovio_sfm/tools/place_truth.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMaxGapNs = 50'000'000;

struct ImageRange {
  std::string folder;
  size_t first = 0, last = SIZE_MAX;
};

size_t ParseIndex(const std::string& text, const std::string& argument) {
  size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return value;
  throw std::runtime_error(argument + ": expected FOLDER or FOLDER@FIRST:LAST");
}

ImageRange ParseRange(const std::string& argument) {
  const size_t at = argument.rfind('@');
  if (at == std::string::npos) return {argument, 0, SIZE_MAX};
  const size_t colon = argument.find(':', at);
  if (colon == std::string::npos) ParseIndex("", argument);
  return {argument.substr(0, at), ParseIndex(argument.substr(at + 1, colon - at - 1), argument),
          ParseIndex(argument.substr(colon + 1), argument)};
}

// One row of labels: what a query image is to every image of the database.
class Labeler {
 public:
  explicit Labeler(TruthSource source) : source_(source) {}

  PlaceLabel LabelOf(const PlaceImages& queries, size_t query, const PlaceImages& others,
                     size_t other) {
    if (source_ == TruthSource::kOverlaps) return FromOverlaps(queries, query, others, other);
    if (!queries.poses[query] || !others.poses[other]) return PlaceLabel::kBetween;
    return LabelOfPoses(*queries.poses[query], *others.poses[other]);
  }

 private:
  using Pairs = std::map<std::pair<uint32_t, uint32_t>, PlaceLabel>;

  PlaceLabel FromOverlaps(const PlaceImages& queries, size_t query, const PlaceImages& others,
                          size_t other) {
    if (queries.dataset.path != others.dataset.path) return PlaceLabel::kNegative;
    const Pairs& pairs = PairsOf(queries.dataset);
    const uint32_t a = queries.indices[query], b = others.indices[other];
    const auto pair = pairs.find({std::min(a, b), std::max(a, b)});
    if (a == b) return PlaceLabel::kPositive;
    return pair == pairs.end() ? PlaceLabel::kNegative : pair->second;
  }

  const Pairs& PairsOf(const DatasetFolder& dataset) {
    const auto [found, is_new] = pairs_.try_emplace(dataset.path);
    if (!is_new) return found->second;
    for (const DatasetOverlap& overlap : dataset.overlaps) {
      found->second[{std::min(overlap.image_a, overlap.image_b),
                     std::max(overlap.image_a, overlap.image_b)}] =
          LabelOfOverlap(overlap.covisible_share, overlap.angle_deg);
    }
    return found->second;
  }

  TruthSource source_;
  std::map<std::filesystem::path, Pairs> pairs_;
};

PlaceLabel LabelOfNumber(const TextLine& line, size_t field) {
  const double number = line.Number(field, "label");
  if (number == 1.0) return PlaceLabel::kPositive;
  if (number == 0.0) return PlaceLabel::kNegative;
  if (number == -1.0) return PlaceLabel::kBetween;
  line.Fail("field label: expected 1, 0 or -1, got '" + line.fields[field] + "'");
}

// Of the folders, each once, the files that would tell the truth and are not there, or say nothing.
std::set<std::string> MissingTruth(const std::vector<PlaceImages>& folders, TruthSource source) {
  std::set<std::string> missing;
  for (const PlaceImages& folder : folders) {
    const DatasetFolder& dataset = folder.dataset;
    const bool from_poses = source == TruthSource::kPoses;
    if (from_poses ? !dataset.ground_truth.empty() : !dataset.overlaps.empty()) continue;
    const auto file = dataset.path / (from_poses ? "groundtruth.txt" : "overlaps.txt");
    missing.insert(file.string() + (std::filesystem::exists(file) ? " is empty" : " is missing"));
  }
  return missing;
}

}  // namespace

PlaceLabel LabelOfOverlap(double covisible_share, double angle_deg) {
  if (covisible_share < 0.05) return PlaceLabel::kNegative;
  const bool is_positive = covisible_share >= 0.4 && angle_deg < 25.0;
  return is_positive ? PlaceLabel::kPositive : PlaceLabel::kBetween;
}

PlaceLabel LabelOfPoses(const Rigid3& world_from_a, const Rigid3& world_from_b) {
  const double distance_m = (world_from_a.translation - world_from_b.translation).norm();
  const Eigen::Vector3d axis_a = world_from_a.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis_b = world_from_b.rotation * Eigen::Vector3d::UnitZ();
  const double angle_rad = std::acos(std::clamp(axis_a.dot(axis_b), -1.0, 1.0));
  if (distance_m > 1.5 || angle_rad > Radians(60.0)) return PlaceLabel::kNegative;
  const bool is_positive = distance_m <= 0.5 && angle_rad <= Radians(30.0);
  return is_positive ? PlaceLabel::kPositive : PlaceLabel::kBetween;
}

PlaceImages ReadPlaceImages(const std::string& argument, size_t stride) {
  const ImageRange range = ParseRange(argument);
  PlaceImages images;
  images.dataset = ReadDatasetFolder(range.folder);
  const size_t end = std::min(images.dataset.images.size(), std::max(range.last, range.last + 1));
  for (size_t i = range.first; i < end; i += stride) {
    images.indices.push_back(static_cast<uint32_t>(i));
    images.poses.push_back(
        InterpolatePose(images.dataset.ground_truth, images.dataset.images[i].stamp_ns, kMaxGapNs));
  }
  if (images.indices.empty()) throw std::runtime_error(argument + ": no images in that range");
  return images;
}

PlaceTruth FindPlaceTruth(const std::vector<PlaceImages>& queries,
                          const std::vector<PlaceImages>& database, size_t num_distractors,
                          TruthSource source) {
  PlaceTruth truth;
  Labeler labeler(source);
  for (const PlaceImages& folder : queries) {
    for (size_t query = 0; query < folder.indices.size(); ++query) {
      std::vector<PlaceLabel>& row = truth.emplace_back();
      for (const PlaceImages& others : database) {
        for (size_t other = 0; other < others.indices.size(); ++other) {
          row.push_back(labeler.LabelOf(folder, query, others, other));
        }
      }
      row.insert(row.end(), num_distractors, PlaceLabel::kNegative);
    }
  }
  return truth;
}

std::string WhyNoPositive(const std::vector<PlaceImages>& queries,
                          const std::vector<PlaceImages>& database, size_t self_gap,
                          TruthSource source) {
  std::set<std::string> missing = MissingTruth(queries, source);
  if (self_gap == 0) missing.merge(MissingTruth(database, source));
  std::string files;
  for (const std::string& file : missing) files += (files.empty() ? "" : "; ") + file;
  if (!files.empty()) return files;
  const std::string place =
      source == TruthSource::kPoses ? "by their ground truth" : "by overlaps.txt of one folder";
  if (self_gap > 0) {
    return "none shows the same place as one at least " + std::to_string(self_gap) +
           " images before, " + place;
  }
  return "no image of the database shows the same place as one of them, " + place;
}

PlaceTruth ReadPlaceTruth(const std::filesystem::path& file, size_t num_queries,
                          size_t num_database, size_t num_distractors) {
  PlaceTruth truth;
  for (const TextLine& line : ReadTextFile(file)) {
    line.RequireFields(num_database, "a label per database image");
    std::vector<PlaceLabel>& row = truth.emplace_back();
    for (size_t i = 0; i < num_database; ++i) row.push_back(LabelOfNumber(line, i));
    row.insert(row.end(), num_distractors, PlaceLabel::kNegative);
  }
  if (truth.size() == num_queries) return truth;
  throw std::runtime_error(file.string() + ": " + std::to_string(truth.size()) +
                           " rows, expected one for each of " + std::to_string(num_queries) +
                           " queries");
}

}  // namespace rovio_sfm
