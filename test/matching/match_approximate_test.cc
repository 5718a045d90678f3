#include "rovio_sfm/matching/match_approximate.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace rovio_sfm {
namespace {

TEST(MatchApproximately, LeavesOpenCvsGeneratorAsItWas) {
  Descriptors a;
  a.type = DescriptorType::kSift;
  a.length = 4;
  for (int i = 0; i < 400; ++i) a.data.push_back(static_cast<uint8_t>(i * 37));
  const uint64_t state = cv::theRNG().state;
  MatchOptions options;
  options.matcher = Matcher::kKdTree;
  EXPECT_EQ(MatchApproximately(a, a, options).size(), 100u);
  EXPECT_EQ(cv::theRNG().state, state);
}

}  // namespace
}  // namespace rovio_sfm
