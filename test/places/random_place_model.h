#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rovio_sfm/places/place_model.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// Images of a world with a few kinds of room, each with its own frequent words, so that words occur
// together.
inline std::vector<WordBag> RandomBags(size_t count, uint32_t num_words, Rng* rng) {
  constexpr uint32_t kRooms = 3;
  std::vector<WordBag> bags(count);
  for (WordBag& bag : bags) {
    const uint32_t room = rng->UniformInt(kRooms);
    for (uint32_t word = 0; word < num_words; ++word) {
      if (rng->Uniform() < (word % kRooms == room ? 0.5 : 0.1)) bag.push_back(word);
    }
  }
  return bags;
}

// A valid model with random words and a tree learnt from random bags.
inline PlaceModel RandomPlaceModel(uint32_t num_words, size_t num_bags, uint64_t seed) {
  Rng rng(seed);
  Descriptors words;
  words.type = DescriptorType::kSift;
  words.length = 128;
  for (uint32_t i = 0; i < num_words * words.length; ++i) {
    words.data.push_back(static_cast<uint8_t>(rng.UniformInt(100)));
  }
  PlaceModel model;
  model.vocabulary = Vocabulary(words);
  model.training_bags = RandomBags(num_bags, num_words, &rng);
  model.tree = LearnChowLiuTree(model.training_bags, num_words, {});
  model.detector.p_z_given_e = 0.4;
  model.detector.p_z_given_not_e = 0.02;
  model.provenance = "random";
  return model;
}

inline std::shared_ptr<const PlaceModel> SharedRandomPlaceModel(uint32_t num_words, size_t num_bags,
                                                                uint64_t seed) {
  return std::make_shared<const PlaceModel>(RandomPlaceModel(num_words, num_bags, seed));
}

}  // namespace rovio_sfm
