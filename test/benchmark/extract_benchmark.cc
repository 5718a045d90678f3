#include <benchmark/benchmark.h>

#include "features/test_images.h"
#include "rovio_sfm/features/denoise.h"
#include "rovio_sfm/features/extract_features.h"

namespace rovio_sfm {
namespace {

void Extract(benchmark::State& state, DescriptorType type) {
  cv::setNumThreads(1);
  const cv::Mat image = TexturedImage(640, 480, 1);
  ExtractOptions options;
  options.type = type;
  options.max_features = static_cast<int>(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(ExtractFeatures(image, TestCamera(640, 480), options));
  }
}
BENCHMARK_CAPTURE(Extract, sift, DescriptorType::kSift)->Arg(1000)->Arg(2000);
BENCHMARK_CAPTURE(Extract, orb, DescriptorType::kOrb)->Arg(1000);
BENCHMARK_CAPTURE(Extract, akaze, DescriptorType::kAkaze)->Arg(1000);
BENCHMARK_CAPTURE(Extract, surf, DescriptorType::kSurf)->Arg(1000);

void DenoiseImage(benchmark::State& state) {
  cv::setNumThreads(1);
  const cv::Mat image = TexturedImage(640, 480, 1);
  for (auto _ : state) benchmark::DoNotOptimize(Denoise(image, {}));
}
BENCHMARK(DenoiseImage);

}  // namespace
}  // namespace rovio_sfm
