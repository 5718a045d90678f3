#include "rovio_sfm/places/detector_model.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(DetectorOfWord, AgreesWithTheShareOfImagesThatShowTheWord) {
  for (const double false_share : {0.0, 0.05}) {
    for (const double p_z : {0.001, 0.02, 0.2, 0.6, 0.99}) {
      const WordDetector detector = DetectorOfWord({0.25, false_share}, p_z);
      EXPECT_GT(detector.p_e, 0.0);
      EXPECT_LT(detector.p_e, 1.0);
      EXPECT_NEAR(
          detector.p_z_given_e * detector.p_e + detector.p_z_given_not_e * (1.0 - detector.p_e),
          p_z, 1e-12);
    }
  }
}

TEST(DetectorOfWord, SeesRareWordsAgainAsMeasured) {
  EXPECT_NEAR(DetectorOfWord({0.25, 0.0}, 1e-6).p_z_given_e, 0.25, 1e-5);
}

TEST(DetectorOfWord, SeesFrequentWordsAgainMoreOften) {
  EXPECT_GT(DetectorOfWord({0.25, 0.0}, 0.5).p_z_given_e, 0.5);
}

TEST(DetectorOptions, NamesWhatDoesNotFit) {
  std::string error;
  EXPECT_TRUE(IsValid(DetectorOptions{}, &error));
  EXPECT_FALSE((IsValid(DetectorOptions{1.0, 0.0}, &error)));
  EXPECT_EQ(error, "p_z_given_e = 1: expected 0.01 to 0.99");
  EXPECT_FALSE((IsValid(DetectorOptions{0.1, 0.1}, &error)));
  EXPECT_EQ(error, "p_z_given_not_e = 0.1: expected below p_z_given_e");
}

}  // namespace
}  // namespace rovio_sfm
