#include <benchmark/benchmark.h>

#include "rovio_sfm/matching/match_descriptors.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

Descriptors RandomDescriptors(size_t count, DescriptorMetric metric, uint64_t seed) {
  Rng rng(seed);
  Descriptors descriptors;
  descriptors.metric = metric;
  descriptors.type = metric == DescriptorMetric::kL2 ? DescriptorType::kSift : DescriptorType::kOrb;
  descriptors.length = metric == DescriptorMetric::kL2 ? 128 : 32;
  for (size_t i = 0; i < count * descriptors.length; ++i) {
    descriptors.data.push_back(static_cast<uint8_t>(rng.UniformInt(90)));
  }
  return descriptors;
}

void Match(benchmark::State& state, DescriptorMetric metric, Matcher matcher) {
  const auto count = static_cast<size_t>(state.range(0));
  const Descriptors a = RandomDescriptors(count, metric, 1);
  const Descriptors b = RandomDescriptors(count, metric, 2);
  MatchOptions options;
  options.matcher = matcher;
  for (auto _ : state) benchmark::DoNotOptimize(MatchDescriptors(a, b, options));
}
BENCHMARK_CAPTURE(Match, exact_l2, DescriptorMetric::kL2, Matcher::kExact)->Arg(1000)->Arg(2000);
BENCHMARK_CAPTURE(Match, exact_hamming, DescriptorMetric::kHamming, Matcher::kExact)->Arg(2000);
BENCHMARK_CAPTURE(Match, kdtree, DescriptorMetric::kL2, Matcher::kKdTree)->Arg(2000);
BENCHMARK_CAPTURE(Match, kmeans_tree, DescriptorMetric::kL2, Matcher::kKMeansTree)->Arg(2000);

}  // namespace
}  // namespace rovio_sfm
