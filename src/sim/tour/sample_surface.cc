#include "rovio_sfm/sim/tour/sample_surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace rovio_sfm::sim {
namespace {

using Cube = std::array<int32_t, 3>;

struct Picture {
  Rigid3 camera_from_world;
  cv::Mat bgr, contrast;
};

// The standard deviation of the grey levels around each pixel.
cv::Mat ContrastOf(const cv::Mat& bgr) {
  const cv::Size window(9, 9);
  cv::Mat gray, mean, squares;
  cv::cvtColor(bgr, gray, cv::COLOR_BGR2GRAY);
  gray.convertTo(gray, CV_32F);
  cv::boxFilter(gray, mean, CV_32F, window);
  cv::boxFilter(gray.mul(gray), squares, CV_32F, window);
  const cv::Mat variance = cv::max(squares - mean.mul(mean), 0.0);
  cv::Mat deviation;
  cv::sqrt(variance, deviation);
  return deviation;
}

std::vector<Picture> RenderPictures(const ImageRenderer& renderer, const SimulatedTour& tour,
                                    DevelopOptions develop) {
  develop.noise_sigma = 0.0;
  std::vector<Picture> pictures;
  for (size_t i = 0; i < tour.frames.size(); ++i) {
    const TourFrame& frame = tour.frames[i];
    const cv::Mat bgr = DevelopImage(renderer.Render(frame.motion, i), frame.exposure, develop, i);
    pictures.push_back({Inverse(frame.world_from_camera), bgr, ContrastOf(bgr)});
  }
  return pictures;
}

// One sample for each cube that a ray of any picture ends in: where it lies, and on what.
std::map<Cube, SurfaceSample> CastRays(const ImageRenderer& renderer, const SimulatedTour& tour,
                                       const SampleSurfaceOptions& options) {
  std::map<Cube, SurfaceSample> samples;
  const Camera& camera = renderer.camera();
  for (const TourFrame& frame : tour.frames) {
    const Eigen::Vector3f centre = frame.world_from_camera.translation.cast<float>();
    const Eigen::Matrix3f rotation =
        frame.world_from_camera.rotation.toRotationMatrix().cast<float>();
    for (int y = 0; y < camera.height; y += options.step_px) {
      for (int x = 0; x < camera.width; x += options.step_px) {
        const Eigen::Vector3f ray =
            rotation *
            renderer.lens().Direction(static_cast<float>(x), static_cast<float>(y)).normalized();
        const RayHit hit = renderer.world().scene().Trace(centre, ray);
        if (hit.surface < 0 || hit.distance > options.depth_limit_m) continue;
        const Eigen::Vector3f point = centre + ray * hit.distance;
        Cube cube;
        for (int i = 0; i < 3; ++i) {
          cube[static_cast<size_t>(i)] =
              static_cast<int32_t>(std::floor(point(i) / options.spacing_m));
        }
        SurfaceSample sample;
        sample.x_in_world = point;
        sample.object = renderer.world().surfaces()[static_cast<size_t>(hit.surface)].object;
        samples.emplace(cube, sample);
      }
    }
  }
  return samples;
}

// The pixel of a point that the picture sees; nothing of others.
std::optional<cv::Point> FindPixel(const ImageRenderer& renderer, const Picture& picture,
                                   const Eigen::Vector3f& x_in_world) {
  const Eigen::Vector3d x_in_camera = picture.camera_from_world * x_in_world.cast<double>();
  if (x_in_camera.z() < 0.02) return std::nullopt;
  const Eigen::Vector2d x_normalized = x_in_camera.head<2>() / x_in_camera.z();
  if (x_normalized.squaredNorm() > 1.0) return std::nullopt;
  const Eigen::Vector2d x_px = PixelFromNormalized(renderer.camera(), x_normalized);
  const cv::Point pixel(static_cast<int>(std::lround(x_px.x())),
                        static_cast<int>(std::lround(x_px.y())));
  if (!cv::Rect({0, 0}, picture.bgr.size()).contains(pixel)) return std::nullopt;
  const Eigen::Vector3f centre = OriginInA(picture.camera_from_world).cast<float>();
  if (renderer.world().scene().IsBlocked(centre, x_in_world)) return std::nullopt;
  return pixel;
}

// What a picture tells about a point: the inverse of its covariance (1/m^2), for an error of 1 px.
Eigen::Matrix3d InformationOf(const Camera& camera, const Picture& picture,
                              const Eigen::Vector3f& x_in_world) {
  const Eigen::Vector3d from_centre =
      x_in_world.cast<double>() - OriginInA(picture.camera_from_world);
  const Eigen::Vector3d ray = from_centre.normalized();
  const double px_per_m = 0.5 * (camera.fx + camera.fy) / from_centre.norm();
  return px_per_m * px_per_m * (Eigen::Matrix3d::Identity() - ray * ray.transpose());
}

// Adds what the pictures see of it.
SurfaceSample Look(const ImageRenderer& renderer, const std::vector<Picture>& pictures,
                   SurfaceSample sample) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const Picture& picture : pictures) {
    const std::optional<cv::Point> pixel = FindPixel(renderer, picture, sample.x_in_world);
    if (!pixel) continue;
    if (sample.num_views == 0) {
      const auto& bgr = picture.bgr.at<cv::Vec3b>(*pixel);
      sample.color = {bgr[2], bgr[1], bgr[0]};
    }
    ++sample.num_views;
    sample.contrast += picture.contrast.at<float>(*pixel);
    information += InformationOf(renderer.camera(), picture, sample.x_in_world);
  }
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information).eigenvalues()[0];
  if (sample.num_views > 1 && least > 0.0)
    sample.sigma_m = static_cast<float>(1.0 / std::sqrt(least));
  sample.contrast /= static_cast<float>(std::max(sample.num_views, 1u));
  return sample;
}

template <typename T>
void Append(const T& value, std::string* bytes) {
  char buffer[sizeof(T)];
  std::memcpy(buffer, &value, sizeof(T));
  bytes->append(buffer, sizeof(T));
}

}  // namespace

std::vector<SurfaceSample> SampleSurface(const ImageRenderer& renderer, const SimulatedTour& tour,
                                         const DevelopOptions& develop,
                                         const SampleSurfaceOptions& options) {
  const std::vector<Picture> pictures = RenderPictures(renderer, tour, develop);
  std::vector<SurfaceSample> samples;
  for (const auto& [cube, sample] : CastRays(renderer, tour, options)) {
    samples.push_back(Look(renderer, pictures, sample));
  }
  return samples;
}

std::string SurfacePlyBytes(const std::vector<SurfaceSample>& samples, const WorldSpec& world) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\ncomment true surface, lengths in metres\n";
  for (size_t i = 0; i < world.objects.size(); ++i) {
    bytes += "comment object " + std::to_string(i) + " " + world.objects[i].name + "\n";
  }
  bytes += "element vertex " + std::to_string(samples.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\n"
           "property float contrast\nproperty uint views\nproperty float sigma\nproperty int "
           "object\nend_header\n";
  for (const SurfaceSample& sample : samples) {
    for (int i = 0; i < 3; ++i) Append(sample.x_in_world(i), &bytes);
    for (const uint8_t channel : sample.color) Append(channel, &bytes);
    Append(sample.contrast, &bytes);
    Append(sample.num_views, &bytes);
    Append(sample.sigma_m, &bytes);
    Append(sample.object, &bytes);
  }
  return bytes;
}

}  // namespace rovio_sfm::sim
