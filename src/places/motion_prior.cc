#include "rovio_sfm/places/motion_prior.h"

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

void MotionPrior::AddPlace(uint32_t previous) {
  const auto place = static_cast<uint32_t>(previous_.size());
  ROVIO_CHECK(previous == kNoPlace || previous < place);
  previous_.push_back(previous);
  next_.push_back(kNoPlace);
  if (previous != kNoPlace) next_[previous] = place;
}

std::vector<double> MotionPrior::Predict(const FabmapResult& last) const {
  const size_t num_places = previous_.size();
  ROVIO_CHECK(last.posteriors.size() <= num_places);
  if (num_places == 0) return {};
  const double known = 1.0 - options_.uniform_share;
  const double even = options_.uniform_share + known * last.new_place_posterior;
  std::vector<double> weights(num_places, even / static_cast<double>(num_places));
  for (uint32_t place = 0; place < last.posteriors.size(); ++place) {
    const double mass = known * last.posteriors[place];
    double left = mass;
    for (const uint32_t neighbor : {previous_[place], next_[place]}) {
      if (neighbor == kNoPlace) continue;
      weights[neighbor] += 0.5 * options_.move_probability * mass;
      left -= 0.5 * options_.move_probability * mass;
    }
    weights[place] += left;
  }
  return weights;
}

}  // namespace rovio_sfm
