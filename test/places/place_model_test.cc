#include "rovio_sfm/places/place_model.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

#include "places/random_place_model.h"

namespace rovio_sfm {
namespace {

std::vector<uint8_t> BytesOf(const PlaceModel& model) {
  const std::string encoded = EncodePlaceModel(model);
  return std::vector<uint8_t>(encoded.begin(), encoded.end());
}

std::string ComplaintAbout(const std::vector<uint8_t>& bytes) {
  try {
    DecodePlaceModel(bytes, "x.places");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// Makes checksum and size fit again, as an attacker would.
void Seal(std::vector<uint8_t>* bytes) {
  constexpr size_t kHeader = 24;
  const uint64_t size = bytes->size() - kHeader;
  const auto checksum = static_cast<uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), bytes->data() + kHeader, bytes->size() - kHeader));
  std::memcpy(bytes->data() + 12, &checksum, 4);
  std::memcpy(bytes->data() + 16, &size, 8);
}

TEST(PlaceModelFile, ComesBackAsItWas) {
  const PlaceModel model = RandomPlaceModel(20, 15, 1);
  const PlaceModel copy = DecodePlaceModel(BytesOf(model), "x.places");
  EXPECT_EQ(EncodePlaceModel(copy), EncodePlaceModel(model));
  EXPECT_EQ(copy.vocabulary.Words().data, model.vocabulary.Words().data);
  EXPECT_EQ(copy.training_bags, model.training_bags);
  EXPECT_EQ(copy.tree[7].p_z_given_parent_true, model.tree[7].p_z_given_parent_true);
  EXPECT_EQ(copy.detector.p_z_given_e, model.detector.p_z_given_e);
  EXPECT_EQ(copy.provenance, "random");
}

TEST(PlaceModelFile, IsRefusedWhereverItIsCutShort) {
  const std::vector<uint8_t> bytes = BytesOf(RandomPlaceModel(4, 3, 2));
  for (size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<uint8_t> part(bytes.begin(), bytes.begin() + static_cast<ptrdiff_t>(size));
    EXPECT_EQ(ComplaintAbout(part).rfind("x.places: ", 0), 0u) << size;
  }
}

TEST(PlaceModelFile, IsRefusedCutShortEvenWithAFittingChecksum) {
  const std::vector<uint8_t> bytes = BytesOf(RandomPlaceModel(4, 3, 2));
  for (size_t size = 24; size < bytes.size(); ++size) {
    std::vector<uint8_t> part(bytes.begin(), bytes.begin() + static_cast<ptrdiff_t>(size));
    Seal(&part);
    EXPECT_NE(ComplaintAbout(part), "") << size;
  }
}

TEST(PlaceModelFile, IsRefusedWithAnyByteChanged) {
  const std::vector<uint8_t> bytes = BytesOf(RandomPlaceModel(4, 3, 3));
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::vector<uint8_t> changed = bytes;
    changed[i] ^= 0x10;
    EXPECT_NE(ComplaintAbout(changed), "") << i;
  }
}

TEST(PlaceModelFile, SurvivesAnyByteChangedWithAFittingChecksum) {
  const std::vector<uint8_t> bytes = BytesOf(RandomPlaceModel(4, 3, 3));
  for (size_t i = 24; i < bytes.size(); ++i) {
    std::vector<uint8_t> changed = bytes;
    changed[i] = static_cast<uint8_t>(changed[i] + 0x81);
    Seal(&changed);
    ComplaintAbout(changed);  // refused or a valid model, never a crash
  }
}

TEST(PlaceModelFile, NamesFieldAndValue) {
  std::vector<uint8_t> bytes = BytesOf(RandomPlaceModel(4, 3, 4));
  std::vector<uint8_t> newer = bytes;
  newer[8] = 9;
  EXPECT_EQ(ComplaintAbout(newer), "x.places: version = 9: expected 1");
  std::vector<uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_EQ(ComplaintAbout(longer),
            "x.places: payload size = " + std::to_string(bytes.size() - 24) + ": the file holds " +
                std::to_string(bytes.size() - 23));
  Seal(&longer);
  EXPECT_EQ(ComplaintAbout(longer), "x.places: 1 bytes too many");
  EXPECT_EQ(ComplaintAbout({'R', 'I', 'F', 'F', 0, 0, 0, 0, 0}),
            "x.places: magic: not a place model");
  EXPECT_EQ(ComplaintAbout({'R'}), "x.places: cut short at magic: needs 8 bytes, 1 are left");
}

TEST(PlaceModelFile, IsRefusedWithMoreWordsThanTheBytesHold) {
  std::vector<uint8_t> bytes = BytesOf(RandomPlaceModel(4, 3, 5));
  const size_t words_at = 24 + 4 + 6 + 1 + 4;  // header, provenance "random", type, length
  bytes[words_at + 1] = 0xff;
  Seal(&bytes);
  EXPECT_EQ(ComplaintAbout(bytes).rfind("x.places: cut short at words: needs ", 0), 0u);
}

TEST(PlaceModel, NamesThePartThatDoesNotFit) {
  const PlaceModel model = RandomPlaceModel(4, 3, 6);
  std::string error;
  EXPECT_TRUE(model.IsValid(&error)) << error;
  PlaceModel broken = model;
  broken.training_bags = {{2, 1}};
  EXPECT_FALSE(broken.IsValid(&error));
  EXPECT_EQ(error, "training bag 0: words not ascending or too great");
  broken.training_bags = {{4}};
  EXPECT_FALSE(broken.IsValid(&error));
  broken = model;
  broken.tree.pop_back();
  EXPECT_FALSE(broken.IsValid(&error));
  EXPECT_EQ(error, "tree nodes = 3: expected one of each of 4 words");
  broken = model;
  broken.detector.p_z_given_e = 2.0;
  EXPECT_FALSE(broken.IsValid(&error));
  EXPECT_FALSE(PlaceModel().IsValid(&error));
}

}  // namespace
}  // namespace rovio_sfm
