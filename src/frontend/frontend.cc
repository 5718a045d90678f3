#include "rovio_sfm/frontend/frontend.h"

#include <memory>
#include <utility>

#include "rovio_sfm/geometry/same_camera.h"
#include "rovio_sfm/scene/stamp_order.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

// Features that some verified pair holds: those that have or will soon have a landmark.
std::vector<bool> MatchedFeatures(const FrameEvent& event) {
  std::vector<bool> matched(event.features->keypoints.size(), false);
  for (const PairMatches& pair : event.pairs) {
    for (const FeatureMatch& match : pair.inliers) matched[match.b] = true;
  }
  return matched;
}

}  // namespace

Frontend::Drive::Drive(const DriveId& drive_id, const Camera& drive_camera,
                       const FrontendOptions& options)
    : id(drive_id),
      camera(drive_camera),
      newest_ns(drive_id.start_ns),
      chooser(options.choose),
      light(options.light),
      tracks(options.track) {}

Frontend::Frontend(const FrontendOptions& options, std::string robot, uint64_t seed, uint32_t nonce,
                   StageTimes* times)
    : options_(options), robot_(std::move(robot)), seed_(seed), nonce_(nonce), times_(times) {
  std::string error;
  ROVIO_CHECK(IsValid(options_, &error), error);
}

bool Frontend::SetOptions(const FrontendOptions& options, std::string* error) {
  if (!MayFollow(options_, options, error)) return false;
  options_ = options;
  if (!drive_) return true;
  drive_->chooser.SetOptions(options.choose);
  drive_->light.SetOptions(options.light);
  drive_->tracks.SetOptions(options.track);
  return true;
}

std::optional<FrameEvent> Frontend::Add(const ImageEvent& image) {
  const auto prepare = [&] {
    const StageTimes::Scope scope = MeasureStage(times_, "prepare");
    return PrepareImage(image, options_);
  };
  return Add(prepare());
}

std::optional<FrameEvent> Frontend::Add(const PreparedImage& image) {
  ++counters_.images;
  if (!image.refusal.empty()) return Drop(&counters_.refused, image.refusal);
  if (!EnsureDrive(image.event)) {
    return Drop(&counters_.late, "image repeated or late: its stamp is not later than the last");
  }
  switch (drive_->chooser.Choose(image.small, image.sharpness, drive_->camera)) {
    case ImageChoice::kKeyframe:
      return AddKeyframe(image);
    case ImageChoice::kLight:
      return AddLightFrame(image);
    case ImageChoice::kSpoilt:
      break;
  }
  return Drop(&counters_.spoilt, "image is of one colour or far more blurred than its drive");
}

std::optional<FrameEvent> Frontend::Drop(uint64_t* counter, const std::string& reason) {
  ++*counter;
  last_refusal_ = reason;
  return std::nullopt;
}

bool Frontend::EnsureDrive(const ImageEvent& image) {
  if (!drive_) {
    StartDrive(image);
    return true;
  }
  const StampOrder order = OrderOf(image.stamp_ns, drive_->newest_ns);
  if (order == StampOrder::kLate) return false;
  const bool is_same_camera = IsSameCamera(image.camera, drive_->camera);
  if (order == StampOrder::kLater && is_same_camera) {
    drive_->newest_ns = image.stamp_ns;
    return true;
  }
  const std::string ended = drive_->id.ToString();
  StartDrive(image);
  LogWarning("drive " + ended + " ends and " + drive_->id.ToString() + " begins: " +
             (is_same_camera ? "time jumped back" : "the camera's size or intrinsics changed"));
  return true;
}

void Frontend::StartDrive(const ImageEvent& image) {
  const auto nonce = static_cast<uint32_t>(nonce_ + counters_.drives++);
  drive_.emplace(DriveId{robot_, image.stamp_ns, nonce}, image.camera, options_);
}

FrameEvent Frontend::StartEvent(const PreparedImage& image, FrameKind kind) const {
  FrameEvent event;
  event.id = {drive_->id, drive_->next_index};
  event.kind = kind;
  event.stamp_ns = image.event.stamp_ns;
  event.image_name = image.event.name;
  event.camera_frame = image.event.camera_frame;
  event.camera = drive_->camera;
  event.odometry = image.event.odometry;
  event.base_from_camera = image.event.base_from_camera;
  event.blur = image.sharpness;
  if (options_.keep_images) event.jpeg = image.event.encoded;
  return event;
}

std::optional<FrameEvent> Frontend::AddKeyframe(const PreparedImage& image) {
  FrameEvent event = StartEvent(image, FrameKind::kKeyframe);
  {
    const StageTimes::Scope scope = MeasureStage(times_, "extract");
    event.features =
        image.features ? image.features : FindFeatures(image.bgr, event.camera, options_);
  }
  if (event.features->keypoints.size() < static_cast<size_t>(options_.min_features)) {
    return Drop(&counters_.featureless, "image has too few features");
  }
  RecentKeyframe keyframe{event.id.index, event.features,
                          OdomFromCamera(event.odometry, event.base_from_camera)};
  {
    const StageTimes::Scope scope = MeasureStage(times_, "match");
    event.pairs = MatchRecursively(drive_->recent, keyframe, event.camera, options_.pair,
                                   options_.recursion, seed_);
  }
  LinkTracks(&event);
  keyframe.tracks = event.tracks;
  Remember(keyframe);
  FollowFrom(image, event);
  ++drive_->next_index;
  ++counters_.keyframes;
  return event;
}

std::optional<FrameEvent> Frontend::AddLightFrame(const PreparedImage& image) {
  if (!options_.light.enabled) return std::nullopt;
  const StageTimes::Scope scope = MeasureStage(times_, "light");
  LightFeatures light = drive_->light.Follow(image.full, drive_->camera);
  if (light.tracks.size() < static_cast<size_t>(options_.light.min_features)) {
    return Drop(&counters_.untracked, "too few features followed");
  }
  FrameEvent event = StartEvent(image, FrameKind::kLight);
  event.features = std::make_shared<const FrameFeatures>(std::move(light.features));
  event.tracks = std::move(light.tracks);
  ++drive_->next_index;
  ++counters_.light_frames;
  return event;
}

void Frontend::LinkTracks(FrameEvent* event) {
  const StageTimes::Scope scope = MeasureStage(times_, "link");
  std::vector<Eigen::Vector2f> keypoints_px;
  for (const Keypoint& k : event->features->keypoints) keypoints_px.emplace_back(k.x_px, k.y_px);
  TrackUpdate update = drive_->tracks.Add(event->id.index, keypoints_px, event->pairs);
  event->tracks = std::move(update.tracks);
  for (const auto& [a, b] : update.links) event->links.push_back({a, b});
  counters_.links += event->links.size();
  for (const PairMatches& pair : event->pairs) counters_.track_matches += pair.inliers.size();
  counters_.refused_f1 += update.counts.refused_f1;
}

void Frontend::Remember(const RecentKeyframe& keyframe) {
  drive_->recent.push_back(keyframe);
  while (drive_->recent.size() > static_cast<size_t>(options_.recursion.max_frames)) {
    drive_->recent.pop_front();
  }
}

void Frontend::FollowFrom(const PreparedImage& image, const FrameEvent& event) {
  drive_->chooser.StartFrom(image.small);
  if (options_.choose.mode == KeyframeMode::kEvery || !options_.light.enabled) return;
  drive_->light.StartFrom(image.full, event.features, event.tracks, MatchedFeatures(event));
}

}  // namespace rovio_sfm
