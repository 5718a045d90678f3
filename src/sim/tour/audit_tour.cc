#include "rovio_sfm/sim/tour/audit_tour.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/sim/tour/find_overlaps.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kAhead = 5;  // frames after which a quarter of the points shall be gone

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

double DepthRange(const cv::Mat& depth_m) {
  std::vector<double> depths;
  for (const float depth : cv::Mat_<float>(depth_m)) {
    if (depth > 0.0f) depths.push_back(depth);
  }
  return Quantile(depths, 0.95) / std::max(Quantile(depths, 0.05), 1e-6);
}

AuditFigures AuditViews(const Camera& camera, const std::vector<DepthView>& views, int step_px) {
  std::vector<double> ranges, gone;
  for (const DepthView& view : views) ranges.push_back(DepthRange(view.depth_m));
  for (size_t i = 0; i + kAhead < views.size(); ++i) {
    gone.push_back(1.0 - CovisibleShare(camera, views[i], views[i + kAhead], step_px));
  }
  return {
      AtLeast("depth p95 / p5, median frame", Quantile(ranges, 0.5), 4.0),
      AtLeast("share of points gone or hidden 5 frames later, median", Quantile(gone, 0.5), 0.25)};
}

// The robot's own steps; the two straight tours have shorter ones (rovio_sim --steps).
AuditFigures AuditSteps(const Camera& camera, const std::vector<DepthView>& views, int step_px) {
  std::vector<double> medians_px;
  for (size_t i = 1; i < views.size(); ++i) {
    medians_px.push_back(Quantile(FlowsBetween(camera, views[i - 1], views[i], step_px), 0.5));
  }
  return {
      Within("flow from picture to picture, median, px", Quantile(medians_px, 0.5), 15.0, 40.0)};
}

AuditFigures AuditPictures(const ImageRenderer& renderer, const SimulatedTour& tour,
                           DevelopOptions develop, const AuditTourOptions& options) {
  develop.noise_sigma = 0.0;
  std::vector<double> plain;
  const size_t count = static_cast<size_t>(options.num_pictures);
  for (size_t i = 0; i < count; ++i) {
    const TourFrame& frame =
        tour.frames[i * (tour.frames.size() - 1) / std::max(count - 1, size_t{1})];
    const cv::Mat light = renderer.Render(frame.motion, i);
    plain.push_back(PlainShare(DevelopImage(light, frame.exposure, develop, i)));
  }
  return {Within("plain or weak share of a median frame", Quantile(plain, 0.5), 0.30, 0.60)};
}

// How far a point at 2 m in the middle of the picture moves while the shutter is open.
double BlurOf(const Camera& camera, const CameraMotion& motion) {
  const Eigen::Vector3d point = motion.world_from_camera_open * Eigen::Vector3d(0, 0, 2.0);
  const Eigen::Vector3d moved = Inverse(motion.world_from_camera_close) * point;
  return camera.MeanFocal() * moved.head<2>().norm() / moved.z();
}

AuditFigures AuditMotion(const Camera& camera, const SimulatedTour& tour) {
  std::vector<double> heights_m, stops, blurs_px, tilts_deg;
  const double nominal_m = tour.base_from_camera.translation.z();
  for (const TourFrame& frame : tour.frames) {
    const Rigid3& pose = frame.world_from_camera;
    heights_m.push_back(pose.translation.z());
    stops.push_back(std::log2(frame.exposure));
    blurs_px.push_back(BlurOf(camera, frame.motion));
    const Eigen::Vector3d up = pose.rotation * -Eigen::Vector3d::UnitY();
    tilts_deg.push_back(Degrees(std::acos(std::clamp(up.z(), -1.0, 1.0))));
  }
  return {Within("camera's height, lowest, m", Quantile(heights_m, 0.0), 0.1, 0.3),
          Within("camera's height, highest, m", Quantile(heights_m, 1.0), 0.1, 0.3),
          // The arm reaches 8 cm forward, so that pitch adds 0.7 mm to the body's 2 mm.
          Within("rocking: height, greatest, mm",
                 1000.0 * std::max(std::abs(Quantile(heights_m, 1.0) - nominal_m),
                                   std::abs(Quantile(heights_m, 0.0) - nominal_m)),
                 0.3, 4.8),
          Within("rocking: tilt, greatest, deg", Quantile(tilts_deg, 1.0), 0.1, 0.71),
          AtLeast("exposure's range, stops", Quantile(stops, 1.0) - Quantile(stops, 0.0), 1.5),
          Within("blur over the exposure, median, px", Quantile(blurs_px, 0.5), 0.02, 2.0)};
}

bool IsPublishedCamera(const Camera& camera) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 5e-4; };
  return near(camera.fx, 699.282) && near(camera.fy, 687.529) && near(camera.cx, 322.005) &&
         near(camera.cy, 227.160) && near(camera.k1, 0.0218) && near(camera.k2, -0.1098) &&
         camera.width == 640 && camera.height == 480;
}

// What sets the robot's own camera apart.
AuditFigures AuditSensor(const DevelopOptions& develop) {
  return {Within("lens blur, sigma, px", develop.lens_sigma_px, 0.6, 1.2),
          Within("JPEG quality", develop.jpeg_quality, 30, 60),
          Within("correlation of the noise of neighbours", DecodedNoise(develop).correlation, 0.3,
                 0.7)};
}

AuditFigures AuditCamera(const ImageRenderer& renderer, const DevelopOptions& develop) {
  const int samples = renderer.options().samples_per_side * renderer.options().samples_per_side;
  return {Within("published Rovio intrinsics and distortion (1: yes)",
                 IsPublishedCamera(renderer.camera()) ? 1.0 : 0.0, 1.0, 1.0),
          AtLeast("samples a pixel", samples, 4),
          AtLeast("vignetting: light lost in the corners", develop.vignetting, 0.1),
          Within("noise after decoding, grey levels", DecodedNoise(develop).sigma, 9.0, 11.0)};
}

AuditFigures AuditOdometry(const SlipOptions& options, uint64_t seed) {
  double forward = 0.0, least_side = 1.0, most_side = 0.0;
  Rng rng(seed);
  for (int drive = 0; drive < 200; ++drive) {
    const Slip slip = DrawSlip(options, rng);
    forward = std::max(forward, std::abs(slip.forward_gain - 1.0));
    least_side = std::min(least_side, 1.0 - slip.side_gain);
    most_side = std::max(most_side, 1.0 - slip.side_gain);
  }
  return {Within("odometry's forward gain off 1, greatest of 200 drives", forward, 0.03, 0.05),
          Within("sideways loss, least of 200 drives", least_side, 0.15, 0.30),
          Within("sideways loss, most of 200 drives", most_side, 0.15, 0.30),
          AtLeast("heading's random walk, rad per root of a metre",
                  options.heading_walk_rad_per_sqrt_m, 0.005),
          AtLeast("share of lost ticks", options.lost_tick_share, 0.001)};
}

// 1 if other odometry leaves every picture as it was.
double OdometryStandsApart(const TourSpec& spec, const SimulatedTour& tour, uint64_t seed) {
  SlipOptions none;
  none.forward_gain_spread = none.lost_tick_share = none.heading_walk_rad_per_sqrt_m = 0.0;
  const SimulatedTour other = SimulateTour(spec, none, seed);
  for (size_t i = 0; i < tour.frames.size(); ++i) {
    const TourFrame& a = tour.frames[i];
    const TourFrame& b = other.frames[i];
    if (a.world_from_camera.translation != b.world_from_camera.translation) return 0.0;
    if (a.exposure != b.exposure) return 0.0;
  }
  return 1.0;
}

}  // namespace

double PlainShare(const cv::Mat& bgr) {
  constexpr int kBlock_px = 16;
  constexpr double kWeak = 10.0;  // grey levels
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  int plain = 0, total = 0;
  for (int y = 0; y + kBlock_px <= grey.rows; y += kBlock_px) {
    for (int x = 0; x + kBlock_px <= grey.cols; x += kBlock_px) {
      cv::Scalar mean, deviation;
      cv::meanStdDev(grey(cv::Rect(x, y, kBlock_px, kBlock_px)), mean, deviation);
      plain += deviation[0] < kWeak ? 1 : 0;
      ++total;
    }
  }
  return total == 0 ? 0.0 : static_cast<double>(plain) / total;
}

NoiseFigures DecodedNoise(const DevelopOptions& options) {
  constexpr int kPictures = 6;
  const cv::Mat wall(240, 320, CV_32FC3, cv::Scalar::all(0.21));  // middle grey, safe from clipping
  std::vector<cv::Mat> pictures;
  cv::Mat mean(wall.size(), CV_32FC3, cv::Scalar::all(0));
  for (uint64_t seed = 1; seed <= kPictures; ++seed) {
    const cv::Mat picture = DevelopImage(wall, 1.0, options, seed);
    cv::Mat decoded = cv::imdecode(EncodeJpeg(picture, options), cv::IMREAD_COLOR);
    decoded.convertTo(decoded, CV_32F);
    mean += decoded / kPictures;
    pictures.push_back(decoded);
  }
  double squares = 0.0, products = 0.0, brightness_squares = 0.0;
  for (const cv::Mat& picture : pictures) {
    const cv::Mat noise = picture - mean;
    squares += cv::norm(noise, cv::NORM_L2SQR);
    cv::Mat brightness;
    cv::cvtColor(noise, brightness, cv::COLOR_BGR2GRAY);
    brightness_squares += cv::norm(brightness, cv::NORM_L2SQR);
    products += brightness.colRange(1, wall.cols).dot(brightness.colRange(0, wall.cols - 1));
  }
  const double num_values = 3.0 * static_cast<double>(wall.total()) * (kPictures - 1);
  if (squares == 0.0) return {};
  return {std::sqrt(squares / num_values), products / brightness_squares};
}

AuditFigures AuditTour(const ImageRenderer& renderer, const TourSpec& spec, const SlipOptions& slip,
                       const DevelopOptions& develop, uint64_t seed,
                       const AuditTourOptions& options) {
  ROVIO_CHECK(options.num_pictures > 0 && options.depth_step_px > 0);
  const SimulatedTour tour = SimulateTour(spec, slip, seed);
  const Camera& camera = renderer.camera();
  const std::vector<DepthView> views =
      RenderDepths(renderer.world(), camera, tour, options.depth_step_px);
  AuditFigures figures = AuditViews(camera, views, options.depth_step_px);
  const auto append = [&figures](const AuditFigures& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  };
  append(AuditPictures(renderer, tour, develop, options));
  append(AuditMotion(camera, tour));
  append(AuditCamera(renderer, develop));
  if (develop.sensor == Sensor::kBayer) {
    append(AuditSensor(develop));
    append(AuditSteps(camera, views, options.depth_step_px));
  }
  append(AuditOdometry(slip, seed));
  append({Within("odometry is seeded apart from the pictures (1: yes)",
                 OdometryStandsApart(spec, tour, seed), 1.0, 1.0)});
  return figures;
}

}  // namespace rovio_sfm::sim
