#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// The features of one frame by cells of the plane z = 1.
class FeatureGrid {
 public:
  // Points are normalised; the cell is the half width of the windows asked for.
  FeatureGrid(const std::vector<Eigen::Vector2d>& points, double cell);

  // The features of the cells that a window of one cell's half width touches.
  std::vector<uint32_t> Near(const Eigen::Vector2d& point) const;

 private:
  std::pair<int, int> Key(const Eigen::Vector2d& point) const;

  double cell_;
  std::map<std::pair<int, int>, std::vector<uint32_t>> cells_;
};

// Byte descriptors under L2 of one drive's frames, each frame fetched once. Borrows the store.
class DescriptorReader {
 public:
  DescriptorReader(const FrameStore& store, DriveId drive);

  // Null where there is none of that length.
  const uint8_t* Row(const Observation& observation, uint32_t length);
  // Null where the frame or descriptors of bytes under L2 are missing.
  const Descriptors* Of(uint32_t frame);

 private:
  const FrameStore& store_;
  DriveId drive_;
  std::map<uint32_t, std::shared_ptr<const FrameFeatures>> cache_;
};

// Where a search looks, and how well a feature must fit.
struct FeatureWindow {
  const Keyframe& frame;
  const FeatureGrid& grid;
  const Descriptors& descriptors;  // of the frame
  double radius = 0.0;             // normalised
  float max_distance = 300.0f;     // of byte descriptors
  float max_ratio = 0.9f;          // to the second best feature of the window
  double max_error_sigmas = 4.0;   // from the predicted point
};

// The feature near the predicted point (normalised) that looks like the appearance, if one clearly
// does.
std::optional<uint32_t> FindFeature(const FeatureWindow& window, const Eigen::Vector2d& predicted,
                                    const uint8_t* appearance);

}  // namespace rovio_sfm
