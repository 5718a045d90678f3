#include "rovio_sfm/merging/search_across.h"

#include <cmath>
#include <optional>

#include "rovio_sfm/scene/feature_window.h"

namespace rovio_sfm {
namespace {

// The view of a landmark that looks at it most nearly as the given camera centre does.
struct NearestView {
  Observation observation;
  double angle_rad = M_PI;
  double distance_ratio = 0.0;  // the camera's distance / the view's
};

NearestView FindNearestView(const Session& session, const Landmark& landmark,
                            const Eigen::Vector3d& centre) {
  NearestView nearest;
  const Eigen::Vector3d ray = centre - landmark.position;
  for (const Observation& observation : landmark.observations) {
    const Eigen::Vector3d other =
        OriginInA(session.keyframe(observation.frame).cam_from_session) - landmark.position;
    const double angle = std::atan2(ray.cross(other).norm(), ray.dot(other));
    if (angle < nearest.angle_rad) nearest = {observation, angle, ray.norm() / other.norm()};
  }
  return nearest;
}

bool IsInside(const Camera& camera, const Eigen::Vector2d& x_normalized, double margin_px) {
  const Eigen::Vector2d pixel = PixelFromNormalized(camera, x_normalized);
  return pixel.x() >= margin_px && pixel.y() >= margin_px &&
         pixel.x() <= camera.width - 1 - margin_px && pixel.y() <= camera.height - 1 - margin_px;
}

bool MayBeVisible(const NearestView& view, const SearchAcrossOptions& options) {
  return view.angle_rad <= options.max_wide_angle_rad &&
         view.distance_ratio <= options.max_distance_ratio &&
         view.distance_ratio >= 1.0 / options.max_distance_ratio;
}

bool IsExpected(const NearestView& view, const Landmark& landmark,
                const SearchAcrossOptions& options) {
  return MayBeVisible(view, options) && view.angle_rad <= options.max_view_angle_rad &&
         landmark.observations.size() >= static_cast<size_t>(options.min_views);
}

void Count(bool is_expected, bool is_wide, bool is_found, AcrossReport* report) {
  report->num_expected += is_expected ? 1 : 0;
  report->num_found += is_expected && is_found ? 1 : 0;
  report->num_wide += is_wide ? 1 : 0;
  report->num_wide_found += is_wide && is_found ? 1 : 0;
}

bool IsSeenIn(const Landmark& landmark, const FrameRange& range) {
  for (const Observation& observation : landmark.observations) {
    if (observation.frame >= range.first && observation.frame <= range.last) return true;
  }
  return false;
}

// Where the landmark should appear in the frame; nothing where it cannot.
std::optional<Eigen::Vector2d> Predict(const Rigid3& cam_from_a, const Landmark& landmark,
                                       const Camera& camera, double margin_px) {
  constexpr double kWidest = 2.0;  // the distortion is not to be trusted farther out
  const Eigen::Vector3d x_in_cam = cam_from_a * landmark.position;
  if (!(x_in_cam.z() > 1e-9)) return std::nullopt;
  const Eigen::Vector2d predicted = x_in_cam.hnormalized();
  if (predicted.norm() > kWidest || !IsInside(camera, predicted, margin_px)) return std::nullopt;
  return predicted;
}

FeatureWindow WindowOf(const Keyframe& keyframe, const FeatureGrid& grid,
                       const Descriptors& descriptors, double radius,
                       const SearchAcrossOptions& options) {
  return {keyframe,
          grid,
          descriptors,
          radius,
          options.max_distance,
          options.max_ratio,
          options.max_error_sigmas};
}

}  // namespace

AcrossReport SearchAcross(const Session& a, const FrameRange& range_a, const Session& b,
                          uint32_t frame_b, const Sim3& b_from_a,
                          const SearchAcrossOptions& options, const FrameStore& store) {
  AcrossReport report;
  DescriptorReader reader_a(store, a.drive()), reader_b(store, b.drive());
  const Descriptors* descriptors = reader_b.Of(frame_b);
  if (descriptors == nullptr) return report;
  const Keyframe& keyframe = b.keyframe(frame_b);
  const double radius = options.radius_px / b.camera().MeanFocal();
  const FeatureGrid grid(keyframe.points, radius);
  const FeatureWindow window = WindowOf(keyframe, grid, *descriptors, radius, options);
  const Rigid3 cam_from_a = TransformCamera(Inverse(b_from_a), keyframe.cam_from_session);
  for (const auto& [id, landmark] : a.landmarks()) {
    if (!IsSeenIn(landmark, range_a)) continue;
    if (&a == &b && IsSeenIn(landmark, {frame_b, frame_b})) {
      const bool counts = landmark.observations.size() >= static_cast<size_t>(options.min_views);
      Count(counts, true, true, &report);
      continue;
    }
    const auto predicted = Predict(cam_from_a, landmark, b.camera(), options.radius_px);
    if (!predicted) continue;
    const NearestView view = FindNearestView(a, landmark, OriginInA(cam_from_a));
    const uint8_t* appearance = reader_a.Row(view.observation, descriptors->length);
    if (appearance == nullptr) continue;
    const std::optional<uint32_t> feature = FindFeature(window, *predicted, appearance);
    Count(IsExpected(view, landmark, options), MayBeVisible(view, options), feature.has_value(),
          &report);
    if (!feature) continue;
    report.links.push_back(
        {{a.id(), view.observation.frame, view.observation.feature}, {b.id(), frame_b, *feature}});
  }
  return report;
}

}  // namespace rovio_sfm
