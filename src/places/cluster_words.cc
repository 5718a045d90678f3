#include "rovio_sfm/places/cluster_words.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "rovio_sfm/places/vocabulary.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr size_t kSampleFactor = 20;    // features a word that seeding looks at …
constexpr size_t kMinSample = 10'000;   // … but never fewer
constexpr size_t kMaxSeedBatch = 64;    // words drawn at once …
constexpr size_t kSeedBatchShare = 16;  // … and at most this part of the words drawn before
constexpr size_t kTaskRows = 4096;      // features a task

Descriptors EmptyLike(const Descriptors& features) {
  return {features.type, features.metric, features.length, {}};
}

void AppendRow(const Descriptors& from, size_t row, Descriptors* to) {
  to->data.insert(to->data.end(), from.Row(row), from.Row(row) + from.length);
}

// At most count rows, without repetition, in random order.
Descriptors SampleRows(const Descriptors& features, size_t count, Rng* rng) {
  std::vector<uint32_t> rows(features.Count());
  std::iota(rows.begin(), rows.end(), 0u);
  count = std::min(count, rows.size());
  Descriptors sample = EmptyLike(features);
  for (size_t i = 0; i < count; ++i) {
    std::swap(rows[i], rows[i + rng->UniformInt(static_cast<uint32_t>(rows.size() - i))]);
    AppendRow(features, rows[i], &sample);
  }
  return sample;
}

// Draws rows with probability proportional to their squared distance to the words so far.
class SeedDrawer {
 public:
  explicit SeedDrawer(const Descriptors& sample)
      : sample_(sample),
        rows_(ToFloatRows(sample.data, sample.length)),
        distances_(sample.Count(), std::numeric_limits<float>::max()) {}

  // Counts the words in words from row `first` on as drawn.
  void Add(const Descriptors& words, size_t first) {
    Descriptors fresh = EmptyLike(words);
    fresh.data.assign(words.data.begin() + static_cast<std::ptrdiff_t>(first * words.length),
                      words.data.end());
    const auto nearest = FindNearestCenters(ToFloatRows(fresh.data, fresh.length), rows_);
    for (size_t i = 0; i < nearest.size(); ++i) {
      distances_[i] = std::min(distances_[i], nearest[i].squared_distance);
    }
  }

  // `count` rows, each once, appended to words; fewer if no row lies apart from the words.
  void Draw(size_t count, Rng* rng, Descriptors* words) {
    for (size_t i = 0; i < count; ++i) {
      const double total = std::accumulate(distances_.begin(), distances_.end(), 0.0);
      if (total <= 0.0) return;
      const size_t row = RowAt(rng->Uniform() * total);
      AppendRow(sample_, row, words);
      distances_[row] = 0.0f;
    }
  }

 private:
  // The row in which a running sum of the distances passes target.
  size_t RowAt(double target) const {
    double sum = 0.0;
    size_t last = 0;
    for (size_t row = 0; row < distances_.size(); ++row) {
      if (distances_[row] <= 0.0f) continue;
      last = row;
      sum += distances_[row];
      if (sum > target) return row;
    }
    return last;
  }

  const Descriptors& sample_;
  FloatRows rows_;
  std::vector<float> distances_;  // squared, whole numbers
};

using Nearest = std::vector<NearestCenter>;

// The nearest word of each feature, in tasks consumed in order.
Nearest AssignFeatures(const Descriptors& features, const FloatRows& words, Executor* executor) {
  TaskGroup<Nearest> tasks(executor);
  for (size_t begin = 0; begin < features.Count(); begin += kTaskRows) {
    const size_t end = std::min(begin + kTaskRows, features.Count());
    tasks.Add([&features, &words, begin, end] {
      const std::vector<uint8_t> rows(features.Row(begin), features.Row(end));
      return FindNearestCenters(words, ToFloatRows(rows, features.length));
    });
  }
  Nearest nearest;
  nearest.reserve(features.Count());
  while (tasks.NumPending() > 0) {
    const Nearest part = tasks.TakeNext();
    nearest.insert(nearest.end(), part.begin(), part.end());
  }
  return nearest;
}

// The features farthest from their words, farthest first, the first of equals.
std::vector<uint32_t> FarthestFeatures(const Nearest& nearest, size_t count) {
  std::vector<uint32_t> rows(nearest.size());
  std::iota(rows.begin(), rows.end(), 0u);
  count = std::min(count, rows.size());
  std::partial_sort(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), rows.end(),
                    [&](uint32_t a, uint32_t b) {
                      const float far_a = nearest[a].squared_distance;
                      const float far_b = nearest[b].squared_distance;
                      return far_a != far_b ? far_a > far_b : a < b;
                    });
  rows.resize(count);
  return rows;
}

// The rounded mean of each word's features; 0 counts for words without any.
struct WordSums {
  std::vector<uint64_t> sums;
  std::vector<uint64_t> counts;
};

WordSums SumByWord(const Descriptors& features, const Nearest& nearest, size_t num_words) {
  WordSums result{std::vector<uint64_t>(num_words * features.length, 0),
                  std::vector<uint64_t>(num_words, 0)};
  for (size_t i = 0; i < nearest.size(); ++i) {
    ++result.counts[nearest[i].index];
    uint64_t* sums = &result.sums[size_t{nearest[i].index} * features.length];
    for (uint32_t k = 0; k < features.length; ++k) sums[k] += features.Row(i)[k];
  }
  return result;
}

Descriptors MoveWords(const Descriptors& features, const Nearest& nearest, size_t num_words) {
  const WordSums sums = SumByWord(features, nearest, num_words);
  const auto num_empty =
      static_cast<size_t>(std::count(sums.counts.begin(), sums.counts.end(), uint64_t{0}));
  const std::vector<uint32_t> farthest = FarthestFeatures(nearest, num_empty);
  Descriptors words = EmptyLike(features);
  size_t num_replaced = 0;
  for (size_t word = 0; word < num_words; ++word) {
    const uint64_t count = sums.counts[word];
    if (count == 0) {
      AppendRow(features, farthest[num_replaced++ % farthest.size()], &words);
      continue;
    }
    for (uint32_t k = 0; k < features.length; ++k) {
      const uint64_t sum = sums.sums[word * features.length + k];
      words.data.push_back(static_cast<uint8_t>((2 * sum + count) / (2 * count)));
    }
  }
  return words;
}

double MeanSquaredDistance(const Nearest& nearest) {
  double sum = 0.0;  // whole numbers: exact
  for (const NearestCenter& one : nearest) sum += one.squared_distance;
  return sum / static_cast<double>(nearest.size());
}

}  // namespace

ClusterState SeedWords(const Descriptors& features, const ClusterOptions& options, Rng* rng) {
  ROVIO_CHECK(features.Count() > 0 && features.metric == DescriptorMetric::kL2);
  const auto num_words = static_cast<size_t>(options.num_words);
  const Descriptors sample =
      SampleRows(features, std::max(kSampleFactor * num_words, kMinSample), rng);
  ClusterState state;
  state.words = EmptyLike(features);
  AppendRow(sample, 0, &state.words);
  SeedDrawer drawer(sample);
  drawer.Add(state.words, 0);
  while (state.words.Count() < num_words) {
    const size_t drawn = state.words.Count();
    const size_t batch = std::clamp<size_t>(drawn / kSeedBatchShare, 1, kMaxSeedBatch);
    drawer.Draw(std::min(batch, num_words - drawn), rng, &state.words);
    if (state.words.Count() == drawn) AppendRow(sample, drawn % sample.Count(), &state.words);
    drawer.Add(state.words, drawn);
  }
  return state;
}

ClusterState ImproveWords(const Descriptors& features, const ClusterState& state,
                          const ClusterOptions& options, Executor* executor) {
  const FloatRows words = ToFloatRows(state.words.data, state.words.length);
  const Nearest nearest = AssignFeatures(features, words, executor);
  ClusterState next;
  next.num_iterations = state.num_iterations + 1;
  next.words = MoveWords(features, nearest, state.words.Count());
  next.mean_squared_distance = MeanSquaredDistance(nearest);
  const double gain = state.mean_squared_distance - next.mean_squared_distance;
  next.converged =
      next.words.data == state.words.data ||
      (state.num_iterations > 0 && gain <= options.min_gain * state.mean_squared_distance);
  return next;
}

ClusterState ClusterWords(const Descriptors& features, const ClusterOptions& options,
                          std::optional<ClusterState> resumed, Rng* rng, Executor* executor,
                          const std::function<void(const ClusterState&)>& after_iteration) {
  ClusterState state;
  if (resumed.has_value()) {
    state = std::move(*resumed);
  } else {
    state = SeedWords(features, options, rng);
    after_iteration(state);
  }
  while (!state.converged && state.num_iterations < static_cast<uint32_t>(options.max_iterations)) {
    state = ImproveWords(features, state, options, executor);
    after_iteration(state);
  }
  return state;
}

}  // namespace rovio_sfm
