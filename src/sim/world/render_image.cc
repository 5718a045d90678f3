#include "rovio_sfm/sim/world/render_image.h"

#include <array>
#include <cmath>

#include "rovio_sfm/sim/world/lens_table.h"
#include "rovio_sfm/sim/world/pixel_hash.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

using Eigen::Vector3f;

struct CameraPose {
  Eigen::Matrix3f rotation;  // world from camera
  Vector3f center;
};

constexpr int kPoses = 128;  // along the motion; finer than any blur that can be seen
using MotionTable = std::array<CameraPose, kPoses>;

MotionTable TabulateMotion(const CameraMotion& motion) {
  MotionTable table;
  for (int i = 0; i < kPoses; ++i) {
    const Rigid3 pose = PoseAt(motion, (i + 0.5) / kPoses);
    table[static_cast<size_t>(i)] = {pose.rotation.toRotationMatrix().cast<float>(),
                                     pose.translation.cast<float>()};
  }
  return table;
}

struct Guest {
  const World& world;
  Eigen::Matrix3f rotation;  // guest from world
  Vector3f translation;
};

std::vector<Guest> PrepareGuests(const std::vector<PlacedWorld>& placed) {
  std::vector<Guest> guests;
  for (const PlacedWorld& guest : placed) {
    const Rigid3 guest_from_world = Inverse(guest.outer_from_world);
    guests.push_back({*guest.world, guest_from_world.rotation.toRotationMatrix().cast<float>(),
                      guest_from_world.translation.cast<float>()});
  }
  return guests;
}

// One rendering: everything that a row needs.
struct Job {
  const ImageRenderer& renderer;
  const MotionTable poses;
  const std::vector<Guest> guests;
  uint64_t seed;
  float spread_rad;
};

// Of the world, or of a guest that stands nearer.
Vector3f RadianceOf(const Job& job, const Vector3f& origin, const Vector3f& direction,
                    const RayHit& hit, const Eigen::Vector2f& chance) {
  const Guest* nearest = nullptr;
  RayHit nearest_hit = hit;
  for (const Guest& guest : job.guests) {
    const RayHit of_guest = guest.world.scene().Trace(guest.rotation * origin + guest.translation,
                                                      guest.rotation * direction);
    const bool is_nearer = nearest_hit.surface < 0 || of_guest.distance < nearest_hit.distance;
    if (of_guest.surface < 0 || !is_nearer) continue;
    nearest = &guest;
    nearest_hit = of_guest;
  }
  if (nearest == nullptr) {
    return job.renderer.world().Radiance(origin, direction, hit, job.spread_rad, chance);
  }
  return nearest->world.Radiance(nearest->rotation * origin + nearest->translation,
                                 nearest->rotation * direction, nearest_hit, job.spread_rad,
                                 chance);
}

struct Sample {
  int col;
  Eigen::Vector2f chance;
};

// Sets ray i of the packet to sample k of a pixel.
Sample AimRay(const Job& job, int row, int col, int k, int i, RayPacket* rays) {
  const int side = job.renderer.options().samples_per_side;
  const float count = static_cast<float>(side * side);
  const uint64_t hash = HashPixel(job.seed, static_cast<uint32_t>(row), static_cast<uint32_t>(col),
                                  static_cast<uint32_t>(k));
  const float step = 1.0f / static_cast<float>(side);
  const float x = static_cast<float>(col) - 0.5f +
                  (static_cast<float>(k % side) + UnitFromHash(hash, 0)) * step;
  const float y = static_cast<float>(row) - 0.5f +
                  (static_cast<float>(k / side) + UnitFromHash(hash, 1)) * step;
  // The samples of a pixel take the strata of time in an order that changes from pixel to pixel.
  const int stratum = (k + 3 * col + 5 * row) % (side * side);
  const float moment = (static_cast<float>(stratum) + UnitFromHash(hash, 2)) / count;
  const float rolling = static_cast<float>(job.renderer.options().rolling_share);
  const float share = rolling * (static_cast<float>(row) + 0.5f) /
                          static_cast<float>(job.renderer.camera().height) +
                      (1.0f - rolling) * moment;
  const CameraPose& pose = job.poses[static_cast<size_t>(share * kPoses)];
  rays->origins[i] = pose.center;
  rays->directions[i] = (pose.rotation * job.renderer.lens().Direction(x, y)).normalized();
  return {col, {UnitFromHash(hash, 3), UnitFromHash(hash * 0x9e3779b97f4a7c15ULL, 3)}};
}

void RenderRow(const Job& job, int row, cv::Mat* image) {
  const int per_pixel =
      job.renderer.options().samples_per_side * job.renderer.options().samples_per_side;
  const int total = per_pixel * job.renderer.camera().width;
  cv::Vec3f* pixels = image->ptr<cv::Vec3f>(row);
  RayPacket rays;
  std::array<Sample, RayPacket::kSize> samples;
  std::array<RayHit, RayPacket::kSize> hits;
  for (int first = 0; first < total; first += RayPacket::kSize) {
    for (int i = 0; i < RayPacket::kSize; ++i) {
      const int n = std::min(first + i, total - 1);
      samples[static_cast<size_t>(i)] = AimRay(job, row, n / per_pixel, n % per_pixel, i, &rays);
    }
    job.renderer.world().scene().Trace(rays, hits.data());
    for (int i = 0; i < std::min(RayPacket::kSize, total - first); ++i) {
      const Sample& sample = samples[static_cast<size_t>(i)];
      const Vector3f radiance = RadianceOf(job, rays.origins[i], rays.directions[i],
                                           hits[static_cast<size_t>(i)], sample.chance) /
                                static_cast<float>(per_pixel);
      pixels[sample.col] += cv::Vec3f(radiance.x(), radiance.y(), radiance.z());
    }
  }
}

}  // namespace

bool RenderOptions::IsValid(std::string* error) const {
  OptionChecker check("render", error);
  check.Range("samples_per_side", samples_per_side, 1, 8);
  check.Range("rolling_share", rolling_share, 0.0, 0.9);
  return check.Passed();
}

Rigid3 PoseAt(const CameraMotion& motion, double share) {
  const Rigid3& open = motion.world_from_camera_open;
  const Rigid3& close = motion.world_from_camera_close;
  return {open.rotation.slerp(share, close.rotation),
          (1.0 - share) * open.translation + share * close.translation};
}

ImageRenderer::ImageRenderer(const World& world, const Camera& camera, const RenderOptions& options)
    : world_(world), camera_(camera), options_(options), lens_(camera) {
  ROVIO_CHECK(options.IsValid(nullptr) && camera.IsValid(nullptr));
}

cv::Mat ImageRenderer::Render(const CameraMotion& motion, uint64_t seed,
                              const std::vector<PlacedWorld>& guests) const {
  const float spread_rad =
      static_cast<float>(1.0 / (camera_.MeanFocal() * options_.samples_per_side));
  const Job job{*this, TabulateMotion(motion), PrepareGuests(guests), seed, spread_rad};
  cv::Mat image(camera_.height, camera_.width, CV_32FC3, cv::Scalar::all(0));
  for (int row = 0; row < camera_.height; ++row) RenderRow(job, row, &image);
  return image;
}

cv::Mat RenderDepth(const World& world, const Camera& camera, const Rigid3& world_from_camera,
                    int step_px) {
  ROVIO_CHECK(step_px > 0);
  const Vector3f center = world_from_camera.translation.cast<float>();
  const Eigen::Matrix3f rotation = world_from_camera.rotation.toRotationMatrix().cast<float>();
  cv::Mat depth(camera.height / step_px, camera.width / step_px, CV_32F, cv::Scalar(0));
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const Eigen::Vector2d x_px(col * step_px + step_px / 2, row * step_px + step_px / 2);
      const auto x = NormalizedFromPixel(camera, x_px);
      if (!x) continue;
      const Vector3f ray(static_cast<float>(x->x()), static_cast<float>(x->y()), 1.0f);
      const RayHit hit = world.scene().Trace(center, (rotation * ray).normalized());
      if (hit.surface >= 0) depth.at<float>(row, col) = hit.distance / ray.norm();
    }
  }
  return depth;
}

}  // namespace rovio_sfm::sim
