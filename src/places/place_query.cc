#include "rovio_sfm/places/place_query.h"

#include <algorithm>
#include <limits>

namespace rovio_sfm {

std::vector<uint32_t> BestPlaces(const std::vector<double>& values, size_t count) {
  std::vector<uint32_t> places;
  for (uint32_t place = 0; place < values.size(); ++place) {
    if (values[place] > -std::numeric_limits<double>::infinity()) places.push_back(place);
  }
  count = std::min(count, places.size());
  std::partial_sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count),
                    places.end(), [&](uint32_t a, uint32_t b) {
                      return values[a] != values[b] ? values[a] > values[b] : a < b;
                    });
  places.resize(count);
  return places;
}

}  // namespace rovio_sfm
