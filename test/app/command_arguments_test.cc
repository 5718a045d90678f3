#include "rovio_sfm/app/command_arguments.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "rovio_sfm/util/parse_arguments.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// The exit status, if there is one, and what the words made of the arguments.
std::optional<int> Parse(std::vector<const char*> words, MappingArguments* arguments) {
  words.insert(words.begin(), "program");
  CLI::App app;
  DeclareMappingArguments(&app, arguments);
  std::ostringstream out;
  return ParseArguments(&app, static_cast<int>(words.size()), words.data(), out);
}

TEST(DeclareMappingArguments, WantsAFolderAndModesThatThereAre) {
  MappingArguments arguments;
  EXPECT_FALSE(Parse({"--out", "x"}, &arguments));
  EXPECT_EQ(Parse({"--help"}, &arguments), 0);
  EXPECT_THROW(Parse({}, &arguments), std::runtime_error);
  EXPECT_THROW(Parse({"--out", "x", "--mode", "some"}, &arguments), std::runtime_error);
  EXPECT_THROW(Parse({"--out", "x", "--seed", "-1"}, &arguments), std::runtime_error);
}

TEST(CompleteMappingArguments, OverridesOnlyWhatWasSaid) {
  MappingArguments arguments;
  arguments.mapper.frontend.extract.max_features = 700;
  ASSERT_FALSE(Parse({"--out", "x", "--mode", "parallax", "--seed", "5"}, &arguments));
  CompleteMappingArguments(&arguments);
  EXPECT_EQ(arguments.mapper.frontend.extract.max_features, 700);
  EXPECT_EQ(arguments.mapper.frontend.choose.mode, KeyframeMode::kParallax);
  EXPECT_EQ(arguments.mapper.mapper.seed, 5u);
}

TEST(DeclareMappingArguments, TurnsThePoseGraphOffOnlyIfTold) {
  MappingArguments arguments;
  ASSERT_FALSE(Parse({"--out", "x", "--max-overlaps", "1"}, &arguments));
  EXPECT_TRUE(arguments.mapper.mapper.merge.use_pose_graph);
  EXPECT_EQ(arguments.mapper.mapper.merge.max_overlaps, 1);
  ASSERT_FALSE(Parse({"--out", "x", "--no-pose-graph"}, &arguments));
  EXPECT_FALSE(arguments.mapper.mapper.merge.use_pose_graph);
}

TEST(CompleteMappingArguments, RefusesWhatIsOutOfRange) {
  MappingArguments arguments;
  ASSERT_FALSE(Parse({"--out", "x", "--features", "0"}, &arguments));
  EXPECT_THROW(CompleteMappingArguments(&arguments), std::runtime_error);
}

TEST(CompleteMappingArguments, ReadsFilesOfOptionsBeforeTheRest) {
  const TemporaryFolder folder;
  const std::filesystem::path file = std::filesystem::path(folder.Path()) / "frontend.yaml";
  std::ofstream(file) << "extract: {type: orb, max_features: 500}\n";
  MappingArguments arguments;
  const std::string path = file.string();
  ASSERT_FALSE(Parse({"--out", "x", "--frontend", path.c_str(), "--features", "600"}, &arguments));
  CompleteMappingArguments(&arguments);
  std::filesystem::remove(file);
  EXPECT_EQ(arguments.mapper.frontend.extract.type, DescriptorType::kOrb);
  EXPECT_EQ(arguments.mapper.frontend.extract.max_features, 600);
  EXPECT_THROW(CompleteMappingArguments(&arguments), std::runtime_error);
}

TEST(CompleteMappingArguments, NamesAFileOfOptionsThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto complaint = [](const std::string& file) {
    MappingArguments arguments;
    arguments.mapper_file = file;
    return MessageOf([&] { CompleteMappingArguments(&arguments); });
  };
  const std::string path = folder.Path();
  EXPECT_EQ(complaint(path), path + ": is a folder; expected a YAML file");
  EXPECT_EQ(complaint("/nope"), "/nope: cannot be read: No such file or directory");
  const std::string twice = folder.Write("two.yaml", "seed: 1\n---\nseed: 2\n");
  EXPECT_NE(complaint(twice).find("line 3"), std::string::npos) << complaint(twice);
  EXPECT_NE(complaint(twice).find("a second document"), std::string::npos) << complaint(twice);
}

TEST(CompleteMappingArguments, DensifiesBesideTheFormats) {
  MappingArguments arguments;
  arguments.densify = true;
  CompleteMappingArguments(&arguments);
  EXPECT_EQ(arguments.formats,
            MapFormats({MapFormat::kTum, MapFormat::kPly, MapFormat::kDensified}));
}

TEST(CompleteMappingArguments, ReadsTheFormats) {
  MappingArguments arguments;
  ASSERT_FALSE(Parse({"--out", "x", "--format", "colmap,ply"}, &arguments));
  CompleteMappingArguments(&arguments);
  EXPECT_EQ(arguments.formats, MapFormats({MapFormat::kPly, MapFormat::kColmap}));
  arguments.format = "obj";
  EXPECT_THROW(CompleteMappingArguments(&arguments), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
