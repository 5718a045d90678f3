#include "rovio_sfm/app/map_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(ReadFormats, ReadsNamesAndStandsInWhereNoneIsGiven) {
  EXPECT_EQ(ReadFormats(""), kDefaultFormats);
  EXPECT_EQ(ReadFormats("nvm"), MapFormats({MapFormat::kNvm}));
  EXPECT_EQ(ReadFormats("colmap,ply,colmap"), MapFormats({MapFormat::kPly, MapFormat::kColmap}));
}

TEST(ReadFormats, RefusesUnknownOnesByName) {
  for (const char* names : {"obj", "ply,obj", "obj,ply"}) {
    const std::string error = MessageOf([&] { ReadFormats(names); });
    EXPECT_EQ(error.find("format = " + std::string(names) + ": expected one or more"), 0u) << error;
    EXPECT_NE(error.find("got \"obj\""), std::string::npos) << error;
    EXPECT_NE(error.find("ply_ascii, kitti"), std::string::npos) << error;
  }
  for (const char* names : {",", "ply,", "PLY", " ply"}) {
    EXPECT_THROW(ReadFormats(names), std::runtime_error) << names;
  }
}

TEST(TakesLong, TellsWhatWaitsForTheFinalMap) {
  EXPECT_TRUE(TakesLong(MapFormat::kDensified));
  EXPECT_TRUE(TakesLong(MapFormat::kMesh));
  EXPECT_FALSE(TakesLong(MapFormat::kPly));
  EXPECT_FALSE(TakesLong(MapFormat::kColmap));
}

TEST(ReadFormats, ReadsEveryName) {
  std::string names = FormatNames();
  names.erase(std::remove(names.begin(), names.end(), ' '), names.end());
  const MapFormats all = ReadFormats(names);
  EXPECT_EQ(all.size(), 13u);
  for (const MapFormat format : all) EXPECT_FALSE(MainPathOf(format).empty());
}

TEST(SourceOf, TellsWhatEachFormatIsWrittenFrom) {
  EXPECT_EQ(SourceOf(MapFormat::kKitti), FormatSource::kMap);
  EXPECT_EQ(SourceOf(MapFormat::kNvm), FormatSource::kModel);
  EXPECT_EQ(SourceOf(MapFormat::kGrid), FormatSource::kFinished);
}

}  // namespace
}  // namespace rovio_sfm
