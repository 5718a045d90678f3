#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/places/chow_liu_tree.h"
#include "rovio_sfm/places/detector_model.h"
#include "rovio_sfm/places/vocabulary.h"
#include "rovio_sfm/places/word_bag.h"

namespace rovio_sfm {

// All that FAB-MAP learns beforehand: made by train_places, shipped as one file, shared immutable.
struct PlaceModel {
  Vocabulary vocabulary;
  ChowLiuTree tree;  // a node a word
  DetectorOptions detector;
  std::vector<WordBag> training_bags;  // of the training images: samples of places never seen
  std::string provenance;              // how it was made, for people; at most 4096 bytes

  // Names the first part that does not fit.
  bool IsValid(std::string* error) const;
};

constexpr uint32_t kPlaceModelVersion = 1;

// The bytes of a model's file (docs/places.md): little-endian, versioned, with checksum.
std::string EncodePlaceModel(const PlaceModel& model);

// The model in a file's bytes. Untrusted: throws std::runtime_error naming file, field and value
// for what is cut short, corrupt, of another version, or not a valid model. Nothing is allocated
// before its size is checked against the bytes that are there.
PlaceModel DecodePlaceModel(const std::vector<uint8_t>& bytes, const std::string& file);

}  // namespace rovio_sfm
