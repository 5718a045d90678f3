#include "rovio_sfm/finish/choose_pairs.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace rovio_sfm {
namespace {

using Earlier = std::set<uint32_t, std::greater<>>;

// Images before it in its drive, the nearest first.
std::vector<uint32_t> PredecessorsOf(const MapModel& model, uint32_t image, size_t max_count) {
  std::vector<uint32_t> predecessors;
  for (uint32_t i = image; i > 0 && predecessors.size() < max_count; --i) {
    if (model.images[i - 1].id.drive != model.images[image].id.drive) break;
    predecessors.push_back(i - 1);
  }
  return predecessors;
}

// How many points two images share, by image and earlier image.
std::vector<std::map<uint32_t, size_t>> CountCommon(const MapModel& model) {
  std::vector<std::map<uint32_t, size_t>> common(model.images.size());
  for (const ModelPoint& point : model.points) {
    for (size_t b = 1; b < point.views.size(); ++b) {
      for (size_t a = 0; a < b; ++a) ++common[point.views[b].image][point.views[a].image];
    }
  }
  return common;
}

// The images that share most points, of equals the later one.
std::vector<uint32_t> OverlapsOf(const std::map<uint32_t, size_t>& common, const Earlier& near,
                                 const PairChoiceOptions& options) {
  std::vector<std::pair<size_t, uint32_t>> ranked;
  for (const auto& [image, count] : common) {
    if (count >= options.min_common && near.count(image) == 0) ranked.emplace_back(count, image);
  }
  std::sort(ranked.begin(), ranked.end(), std::greater<>());
  if (ranked.size() > options.max_overlaps) ranked.resize(options.max_overlaps);
  std::vector<uint32_t> overlaps;
  for (const auto& [count, image] : ranked) overlaps.push_back(image);
  return overlaps;
}

}  // namespace

std::vector<std::vector<uint32_t>> ChoosePairs(const MapModel& model,
                                               const PairChoiceOptions& options) {
  const std::vector<std::map<uint32_t, size_t>> common = CountCommon(model);
  std::vector<Earlier> earlier(model.images.size());
  for (uint32_t i = 0; i < model.images.size(); ++i) {
    const auto predecessors = PredecessorsOf(model, i, options.max_predecessors);
    earlier[i].insert(predecessors.begin(), predecessors.end());
    for (const uint32_t overlap : OverlapsOf(common[i], Earlier(earlier[i]), options)) {
      earlier[i].insert(overlap);
      for (const uint32_t predecessor : predecessors) {
        const auto [first, last] = std::minmax(predecessor, overlap);
        if (first != last) earlier[last].insert(first);
      }
    }
  }
  std::vector<std::vector<uint32_t>> pairs;
  for (const Earlier& images : earlier) pairs.emplace_back(images.begin(), images.end());
  return pairs;
}

}  // namespace rovio_sfm
