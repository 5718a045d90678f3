#include "rovio_sfm/app/finish_run.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "rovio_sfm/io/text_file.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

MappingArguments ArgumentsFor(const TemporaryFolder& folder) {
  MappingArguments arguments;
  arguments.out = folder.Path();
  arguments.store = false;
  return arguments;
}

TEST(RefuseOlderResults, NamesWhatIsThere) {
  const TemporaryFolder folder;
  MappingArguments arguments = ArgumentsFor(folder);
  RefuseOlderResults(arguments);
  std::filesystem::create_directory(folder.Path() / "map_3");
  folder.Write("map_3/trajectory.txt", "");
  const std::string error = MessageOf([&] { RefuseOlderResults(arguments); });
  EXPECT_NE(error.find("map_3/trajectory.txt exists"), std::string::npos) << error;
  arguments.overwrite = true;
  RefuseOlderResults(arguments);
}

TEST(FinishRun, SaysWhyNothingIsThereAndTellsItByItsStatus) {
  const TemporaryFolder folder;
  const MappingArguments arguments = ArgumentsFor(folder);
  const StageTimes times([] { return int64_t{0}; });
  OfflineMapper mapper({}, nullptr, nullptr);
  RunToFinish finish;
  finish.arguments = &arguments;
  finish.mapper = &mapper;
  finish.times = &times;
  finish.run.num_images = 7;
  CountReason("image of 384x256 px", &finish.run.left_out, 7);
  std::ostringstream out;
  EXPECT_EQ(FinishRun(finish, {{"folders", {"a"}}}, out), kNothingRegistered);
  EXPECT_NE(out.str().find("7  image of 384x256 px"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("no image was registered: of 7 images"), std::string::npos) << out.str();
  const auto bytes = ReadBytes(folder.Path() / "summary.json", 100000);
  const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
  EXPECT_EQ(json["folders"][0], "a");
  EXPECT_EQ(json["left_out"]["image of 384x256 px"], 7);
  EXPECT_EQ(json["stopped"], false);
}

}  // namespace
}  // namespace rovio_sfm
