// Place recognition at scale: places and queries drawn from the trained tree.
#include <benchmark/benchmark.h>

#include <memory>
#include <utility>

#include "rovio_sfm/app/place_model_file.h"
#include "rovio_sfm/places/fabmap.h"
#include "rovio_sfm/places/inverted_index.h"
#include "rovio_sfm/places/word_likelihood.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

std::shared_ptr<const PlaceModel> ShippedModel() {
  static const auto model = LoadPlaceModel(ROVIO_SOURCE_DIR "/config/places/indoor.places");
  return model;
}

// An image's words: each drawn given its parent, from the root down.
class BagSampler {
 public:
  explicit BagSampler(const ChowLiuTree& tree) : tree_(tree) {
    std::vector<std::vector<uint32_t>> children(tree.size());
    for (uint32_t word = 0; word < tree.size(); ++word) {
      if (tree[word].parent == kNoParent) {
        order_.push_back(word);
      } else {
        children[tree[word].parent].push_back(word);
      }
    }
    for (size_t i = 0; i < order_.size(); ++i) {  // grows
      const std::vector<uint32_t>& next = children[order_[i]];
      order_.insert(order_.end(), next.begin(), next.end());
    }
  }

  WordBag Draw(Rng* rng) const {
    std::vector<bool> seen(tree_.size());
    std::vector<uint32_t> words;
    for (const uint32_t word : order_) {
      const ChowLiuNode& node = tree_[word];
      double p = node.p_z;
      if (node.parent != kNoParent) {
        p = seen[node.parent] ? node.p_z_given_parent_true : node.p_z_given_parent_false;
      }
      seen[word] = rng->Uniform() < p;
      if (seen[word]) words.push_back(word);
    }
    return BagOfWords(words);
  }

 private:
  const ChowLiuTree& tree_;
  std::vector<uint32_t> order_;  // parents before children
};

// A map of so many places; kept, as benchmarks of one size follow each other.
struct World {
  explicit World(size_t num_places)
      : sampler(ShippedModel()->tree),
        fabmap(ShippedModel(), {}),
        index(ShippedModel()->tree.size()) {
    Rng rng(1);
    for (size_t i = 0; i < num_places; ++i) {
      const WordBag bag = sampler.Draw(&rng);
      num_words += bag.size();
      fabmap.AddPlace(bag);
      index.AddPlace(bag);
    }
    for (int i = 0; i < 20; ++i) queries.push_back(sampler.Draw(&rng));
  }

  BagSampler sampler;
  Fabmap fabmap;
  InvertedIndex index;  // again, to time its postings alone
  std::vector<WordBag> queries;
  size_t num_words = 0;
};

const World& WorldOf(int64_t num_places) {
  static std::unique_ptr<World> world;
  if (world == nullptr || static_cast<int64_t>(world->fabmap.NumPlaces()) != num_places) {
    world = std::make_unique<World>(static_cast<size_t>(num_places));
  }
  return *world;
}

void QueryPlaces(benchmark::State& state) {
  const World& world = WorldOf(state.range(0));
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(world.fabmap.Query({world.queries[i++ % 20], {}, {}}));
  }
  const auto num_places = static_cast<double>(state.range(0));
  state.counters["bytes_per_place"] = static_cast<double>(world.fabmap.NumBytes()) / num_places;
  state.counters["words_per_place"] = static_cast<double>(world.num_words) / num_places;
}

void WalkPostings(benchmark::State& state) {
  const World& world = WorldOf(state.range(0));
  const LikelihoodTable table(ShippedModel()->tree, ShippedModel()->detector);
  std::vector<ObservationWeights> observations;
  for (const WordBag& query : world.queries) observations.push_back(table.WeightsOf(query));
  std::vector<double> sums(world.index.NumPlaces(), 0.0);
  size_t i = 0;
  for (auto _ : state) {
    world.index.AddWeights(observations[i++ % 20].weights, &sums);
    benchmark::DoNotOptimize(sums.data());
  }
  state.counters["weights"] = static_cast<double>(observations[0].weights.size());
}

// All that a query costs beside the postings: an image without words has none.
void PassOverPlaces(benchmark::State& state) {
  const World& world = WorldOf(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(world.fabmap.Query({{}, {}, {}}));
}

void AddPlace(benchmark::State& state) {
  const World& world = WorldOf(1000);
  Fabmap fabmap(ShippedModel(), {});
  size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(fabmap.AddPlace(world.queries[i++ % 20]));
}

void LoadModel(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(LoadPlaceModel(ROVIO_SOURCE_DIR "/config/places/indoor.places"));
  }
}

void QuantizeWords(benchmark::State& state) {
  const Vocabulary& vocabulary = ShippedModel()->vocabulary;
  Descriptors features = vocabulary.Words();
  features.data.resize(static_cast<size_t>(state.range(0)) * features.length);
  for (auto _ : state) benchmark::DoNotOptimize(vocabulary.Quantize(features));
}

void RegisterAll() {
  const auto milliseconds = benchmark::kMillisecond;
  for (const int64_t num_places : {1000, 10'000, 100'000}) {
    benchmark::RegisterBenchmark("QueryPlaces", QueryPlaces)->Arg(num_places)->Unit(milliseconds);
    benchmark::RegisterBenchmark("WalkPostings", WalkPostings)->Arg(num_places)->Unit(milliseconds);
    benchmark::RegisterBenchmark("PassOverPlaces", PassOverPlaces)
        ->Arg(num_places)
        ->Unit(milliseconds);
  }
  benchmark::RegisterBenchmark("AddPlace", AddPlace)->Unit(milliseconds);
  benchmark::RegisterBenchmark("LoadModel", LoadModel)->Unit(milliseconds);
  benchmark::RegisterBenchmark("QuantizeWords", QuantizeWords)->Arg(1000)->Unit(milliseconds);
}

const bool kRegistered = (RegisterAll(), true);

}  // namespace
}  // namespace rovio_sfm
