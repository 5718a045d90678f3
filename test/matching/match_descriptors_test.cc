#include "rovio_sfm/matching/match_descriptors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/check_options.h"
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
    descriptors.data.push_back(static_cast<uint8_t>(rng.UniformInt(256)));
  }
  return descriptors;
}

// The descriptors in reverse order, slightly changed.
Descriptors ReversedCopy(const Descriptors& original) {
  Descriptors copy = original;
  copy.data.clear();
  for (size_t i = original.Count(); i-- > 0;) {
    copy.data.insert(copy.data.end(), original.Row(i), original.Row(i) + original.length);
    copy.data.back() ^= 1;
  }
  return copy;
}

double Distance(const Descriptors& a, size_t i, const Descriptors& b, size_t j) {
  double sum = 0.0;
  for (uint32_t k = 0; k < a.length; ++k) {
    const int x = a.Row(i)[k], y = b.Row(j)[k];
    sum += a.metric == DescriptorMetric::kL2
               ? (x - y) * (x - y)
               : __builtin_popcount(static_cast<unsigned>(x) ^ static_cast<unsigned>(y));
  }
  return a.metric == DescriptorMetric::kL2 ? std::sqrt(sum) : sum;
}

class MatchDescriptorsOfMetric : public testing::TestWithParam<DescriptorMetric> {};

TEST_P(MatchDescriptorsOfMetric, EqualsBruteForce) {
  const Descriptors a = RandomDescriptors(150, GetParam(), 1);
  const Descriptors b = RandomDescriptors(170, GetParam(), 2);
  const std::vector<FeatureMatch> matches = MatchDescriptors(a, b, {});
  ASSERT_EQ(matches.size(), b.Count());
  for (size_t j = 0; j < b.Count(); ++j) {
    double best = 1e9, second = 1e9;
    size_t nearest = 0;
    for (size_t i = 0; i < a.Count(); ++i) {
      const double distance = Distance(a, i, b, j);
      if (distance < best) nearest = i;
      second = std::min(second, std::max(distance, best));
      best = std::min(best, distance);
    }
    EXPECT_EQ(matches[j].a, nearest);
    EXPECT_EQ(matches[j].b, j);
    EXPECT_NEAR(matches[j].distance, best, 1e-3);
    EXPECT_NEAR(matches[j].ratio, best / second, 1e-5);
  }
}

TEST_P(MatchDescriptorsOfMetric, GivesEqualDistancesToTheSmallerIndex) {
  Descriptors a = RandomDescriptors(3, GetParam(), 1);
  a.data.insert(a.data.end(), a.data.begin(), a.data.end());
  const std::vector<FeatureMatch> matches = MatchDescriptors(a, a, {});
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(matches[i].a, i % 3);
    EXPECT_EQ(matches[i].ratio, 1.0f);
  }
}

INSTANTIATE_TEST_SUITE_P(BothMetrics, MatchDescriptorsOfMetric,
                         testing::Values(DescriptorMetric::kL2, DescriptorMetric::kHamming));

class MatchDescriptorsByTree : public testing::TestWithParam<Matcher> {};

TEST_P(MatchDescriptorsByTree, FindsNearCopiesAndIsDeterministic) {
  const Descriptors a = RandomDescriptors(400, DescriptorMetric::kL2, 1);
  const Descriptors b = ReversedCopy(a);
  MatchOptions options;
  options.matcher = GetParam();
  const std::vector<FeatureMatch> matches = MatchDescriptors(a, b, options);
  const std::vector<FeatureMatch> again = MatchDescriptors(a, b, options);
  ASSERT_EQ(matches.size(), again.size());
  size_t num_right = 0;
  for (size_t i = 0; i < matches.size(); ++i) {
    EXPECT_EQ(matches[i].a, again[i].a);
    num_right += matches[i].a + matches[i].b == a.Count() - 1;
  }
  EXPECT_GT(num_right, 320u);
}

INSTANTIATE_TEST_SUITE_P(AllTrees, MatchDescriptorsByTree,
                         testing::Values(Matcher::kExact, Matcher::kKdTree, Matcher::kKMeansTree));

// They take another way.
TEST(MatchDescriptors, ManyGetTheMatchesThatFewGet) {
  const Descriptors a = RandomDescriptors(2100, DescriptorMetric::kL2, 6);
  Descriptors b = RandomDescriptors(1000, DescriptorMetric::kL2, 7);
  const Descriptors copy = ReversedCopy(a);
  b.data.insert(b.data.end(), copy.data.begin(), copy.data.end());
  Descriptors few = b;
  few.data.resize(1100 * size_t{b.length});
  const std::vector<FeatureMatch> of_many = MatchDescriptors(a, b, {});
  const std::vector<FeatureMatch> of_few = MatchDescriptors(a, few, {});
  ASSERT_EQ(of_many.size(), b.Count());
  for (size_t i = 0; i < of_few.size(); ++i) {
    EXPECT_EQ(of_many[i].a, of_few[i].a);
    EXPECT_EQ(of_many[i].b, of_few[i].b);
    EXPECT_EQ(of_many[i].distance, of_few[i].distance);
    EXPECT_EQ(of_many[i].ratio, of_few[i].ratio);
  }
}

TEST(MatchDescriptors, RatioIsOneWithoutASecond) {
  const Descriptors a = RandomDescriptors(1, DescriptorMetric::kL2, 1);
  for (const Matcher matcher : {Matcher::kExact, Matcher::kKdTree}) {
    MatchOptions options;
    options.matcher = matcher;
    const auto matches = MatchDescriptors(a, RandomDescriptors(2, a.metric, 2), options);
    ASSERT_EQ(matches.size(), 2u);
    EXPECT_EQ(matches[0].ratio, 1.0f);
  }
}

TEST(MatchDescriptors, RefusesEmptyAndForeignTypes) {
  const Descriptors l2 = RandomDescriptors(5, DescriptorMetric::kL2, 1);
  const Descriptors bits = RandomDescriptors(5, DescriptorMetric::kHamming, 1);
  EXPECT_TRUE(MatchDescriptors(l2, bits, {}).empty());
  EXPECT_TRUE(MatchDescriptors(l2, {}, {}).empty());
  EXPECT_TRUE(MatchDescriptors({}, l2, {}).empty());
}

}  // namespace
}  // namespace rovio_sfm
