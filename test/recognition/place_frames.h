#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rovio_sfm/places/place_model.h"
#include "rovio_sfm/recognition/verify_place.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/util/rng.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {

// A room whose points have descriptors of their own: what the camera of a drive sees of it.
class SyntheticRoom {
 public:
  explicit SyntheticRoom(uint64_t seed, int num_cams = 12) {
    SyntheticOptions options;
    options.seed = seed;
    options.num_points = 300;
    options.num_cams = num_cams;
    options.noise_px = 0.3;
    world_ = MakeSyntheticWorld(options);
    Rng rng(seed);
    for (size_t i = 0; i < kLength * world_.points.size(); ++i) {
      descriptors_.push_back(static_cast<uint8_t>(rng.UniformInt(91)));  // a row's length: some 512
    }
  }

  const SyntheticWorld& world() const { return world_; }

  std::shared_ptr<const FrameFeatures> FeaturesOf(size_t cam) const {
    auto features = std::make_shared<FrameFeatures>(MakeFeatures(world_, cam));
    features->descriptors.type = DescriptorType::kSift;
    features->descriptors.length = kLength;
    for (const SyntheticView& view : world_.views[cam]) {
      const auto row = descriptors_.begin() + kLength * view.point;
      features->descriptors.data.insert(features->descriptors.data.end(), row, row + kLength);
    }
    return features;
  }

  // A word for each point.
  const std::vector<uint8_t>& descriptors() const { return descriptors_; }

  // The event of a frame; its tracks are the points, counted from first_track.
  FrameEvent EventOf(const FrameId& id, size_t cam, TrackId first_track) const {
    FrameEvent event;
    event.id = id;
    event.camera = world_.camera;
    event.features = FeaturesOf(cam);
    for (const SyntheticView& view : world_.views[cam]) {
      event.tracks.push_back(first_track + view.point);
    }
    return event;
  }

  PlaceFrame FrameOf(const DriveId& drive, size_t cam) const {
    return {{drive, static_cast<uint32_t>(cam)}, FeaturesOf(cam), world_.camera};
  }

 private:
  static constexpr uint32_t kLength = 128;

  SyntheticWorld world_;
  std::vector<uint8_t> descriptors_;
};

// A model that knows the points of the rooms as words; its training images show any of them.
inline std::shared_ptr<const PlaceModel> ModelOf(const std::vector<const SyntheticRoom*>& rooms) {
  Descriptors words;
  words.type = DescriptorType::kSift;
  words.length = 128;
  for (const SyntheticRoom* room : rooms) {
    words.data.insert(words.data.end(), room->descriptors().begin(), room->descriptors().end());
  }
  auto model = std::make_shared<PlaceModel>();
  model->vocabulary = Vocabulary(words);
  const auto num_words = static_cast<uint32_t>(words.Count());
  Rng rng(5);
  for (int i = 0; i < 40; ++i) {
    std::vector<uint32_t> seen(250);
    for (uint32_t& word : seen) word = rng.UniformInt(num_words);
    model->training_bags.push_back(BagOfWords(seen));
  }
  model->tree = LearnChowLiuTree(model->training_bags, num_words, {});
  return model;
}

}  // namespace rovio_sfm
