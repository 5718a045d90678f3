#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// The nearest float. GCC 12 drops the rounding of vectors that are cast to float and back.
double Rounded(double value) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), 24);
  return std::ldexp(std::nearbyint(mantissa), exponent - 24);
}

// Features' pixels are floats, and none is zero: by any cameras and back, a point is the same to
// the byte.
std::optional<Eigen::Vector2d> Renormalized(const Eigen::Vector2d& point, const Camera& from,
                                            const Camera& to) {
  const Eigen::Vector2d pixel = PixelFromNormalized(from, point);
  return NormalizedFromPixel(to, {Rounded(pixel.x()), Rounded(pixel.y())});
}

std::optional<Points> Renormalized(const Points& points, const Camera& from, const Camera& to) {
  Points all;
  all.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    const auto normalized = Renormalized(point, from, to);
    if (!normalized) return std::nullopt;
    all.push_back(*normalized);
  }
  return all;
}

// The features of frames, as they will be once all of them could be normalised.
class NewPoints {
 public:
  NewPoints(const Camera& from, const Camera& to) : from_(from), to_(to) {}

  template <typename Frame>
  bool Add(Frame* frame) {
    auto points = Renormalized(frame->points, from_, to_);
    if (points) places_.emplace_back(&frame->points, std::move(*points));
    return points.has_value();
  }

  template <typename Frame>
  bool AddAll(std::map<uint32_t, Frame>* frames) {
    for (auto& [index, frame] : *frames) {
      if (!Add(&frame)) return false;
    }
    return true;
  }

  // What a journal remembers may be shared with a copy of the session: it is replaced.
  template <typename Frame>
  bool AddAll(SessionEpoch::Parts<uint32_t, Frame>* remembered) {
    for (auto& [index, frame] : *remembered) {
      auto copy = std::make_shared<Frame>(*frame);
      if (!Add(copy.get())) return false;
      copies_.emplace_back([&frame = frame, copy] { frame = copy; });
    }
    return true;
  }

  void Take() {
    for (auto& [place, points] : places_) *place = std::move(points);
    for (const auto& put_back : copies_) put_back();
  }

 private:
  const Camera &from_, &to_;
  std::vector<std::pair<Points*, Points>> places_;
  std::vector<std::function<void()>> copies_;
};

}  // namespace

bool Session::SetCamera(const Camera& camera) {
  if (camera == camera_) return true;
  NewPoints points(camera_, camera);
  if (!points.AddAll(&keyframes_) || !points.AddAll(&light_frames_)) return false;
  for (SessionEpoch& epoch : epochs_) {
    if (!points.AddAll(&epoch.keyframes) || !points.AddAll(&epoch.light_frames)) return false;
  }
  points.Take();
  ++revision_;
  camera_ = camera;
  landmark_blocks_.clear();
  return true;
}

template <typename Frame>
void Session::Normalize(Frame* frame) const {
  if (camera_ == given_camera_) return;
  for (size_t i = 0; i < frame->points.size(); ++i) {
    if (const auto point = Renormalized(frame->points[i], given_camera_, camera_)) {
      frame->points[i] = *point;
    } else {
      frame->tracks[i] = 0;
    }
  }
}

template void Session::Normalize(Keyframe* frame) const;
template void Session::Normalize(LightFrame* frame) const;

}  // namespace rovio_sfm
