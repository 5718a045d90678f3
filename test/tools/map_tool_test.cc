#include "rovio_sfm/tools/map_tool.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "rovio_sfm/app/folder_lock.h"
#include "tools/command_line.h"
#include "tools/kept_maps.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

class MapTool : public ::testing::Test {
 protected:
  int Tool(const std::vector<std::string>& arguments) {
    return RunCommand(MapToolCommand, arguments, &printed_);
  }
  bool Printed(const std::string& text) const { return printed_.find(text) != std::string::npos; }

  const TemporaryFolder folder_;
  const std::string file_ = folder_.Path() / "map.db", new_ = folder_.Path() / "new.db";
  std::string printed_;
};

TEST_F(MapTool, ChecksAndTellsAndRepairs) {
  KeepTwoDrives(file_, true);
  EXPECT_EQ(Tool({"check", file_}), 0);
  EXPECT_EQ(printed_, file_ + ": sound\n");
  EXPECT_EQ(Tool({"info", file_}), 0);
  EXPECT_TRUE(Printed("sessions  2\n")) << printed_;
  Spoil(file_, "UPDATE keyframe SET pose = x'00' WHERE session = 2");
  EXPECT_EQ(Tool({"check", file_}), 1);
  EXPECT_TRUE(Printed("session 2: frame 0: pose: cut short")) << printed_;
  EXPECT_TRUE(Printed(file_ + ": 1 fault; see map_tool repair\n")) << printed_;
  EXPECT_EQ(Tool({"repair", file_, new_}), 1);
  EXPECT_TRUE(Printed("lost: " + file_ + ": session 2: frame 0: pose: cut short")) << printed_;
  EXPECT_TRUE(Printed("copied 24 frames, 1 session and 1 overlap\nwrote " + new_ + "\n"));
  EXPECT_EQ(Tool({"check", new_}), 0) << printed_;
}

// Robots name files and folders of what is exported.
TEST_F(MapTool, RefusesARobotThatLeadsElsewhere) {
  KeepTwoDrives(file_, false);
  Spoil(file_, "UPDATE drive SET robot = '../../elsewhere' WHERE id = 2");
  const std::string fault = "drive 2: robot '../../elsewhere': expected";
  EXPECT_EQ(Tool({"check", file_}), 1);
  EXPECT_TRUE(Printed(fault)) << printed_;
  const std::string out = folder_.Path() / "out" / "deeper";
  const std::string error = MessageOf([&] { Tool({"export", file_, "--out", out}); });
  EXPECT_NE(error.find(fault), std::string::npos) << error;
  EXPECT_FALSE(std::filesystem::exists(folder_.Path() / "elsewhere"));
}

TEST_F(MapTool, ExportsTheLargestMapOrOneThatIsNamed) {
  KeepTwoDrives(file_, false);
  const std::string out = folder_.Path() / "out";
  EXPECT_EQ(Tool({"export", file_, "--out", out}), 0);
  EXPECT_TRUE(Printed("wrote " + out + "/cloud.ply\n")) << printed_;
  EXPECT_NE(ReadText(out + "/trajectory.txt"), "");
  EXPECT_THROW(Tool({"export", file_, "--out", out}), std::runtime_error);  // never silently
  EXPECT_EQ(Tool({"export", file_, "--out", out, "--map", "2", "--overwrite"}), 0);
  EXPECT_EQ(MessageOf([&] {
              Tool({"export", file_, "--out", out, "--map", "9"});
            }),
            file_ + ": map = 9: expected one with posed frames");
}

TEST_F(MapTool, FailsWhereTheMapCannotBeWrittenInAnyOfTheFormats) {
  KeepTwoDrives(file_, false);
  const std::string out = folder_.Path() / "out";
  EXPECT_EQ(Tool({"export", file_, "--out", out, "--format", "grid"}), 1);
  EXPECT_EQ(printed_, "grid: not written, as the map is not metric\n");
  EXPECT_EQ(Tool({"export", file_, "--out", out, "--format", "grid,tum"}), 0);
  EXPECT_TRUE(Printed("grid: not written, as the map is not metric\nwrote ")) << printed_;
}

TEST_F(MapTool, NamesTheFrameWhosePictureHasNoBytes) {
  KeepTwoDrives(file_, false);
  Spoil(file_, "UPDATE image SET jpeg = x''");
  const std::string out = folder_.Path() / "out";
  for (const std::string format : {"dense", "bundler", "nvm"}) {
    const std::string message = MessageOf([&] {
      Tool({"export", file_, "--out", out, "--format", format});
    });
    EXPECT_NE(message.find("frame "), std::string::npos) << message;
    EXPECT_NE(message.find("no bytes"), std::string::npos) << message;
  }
}

TEST_F(MapTool, MergesAndPrunes) {
  const std::string second = folder_.Path() / "second.db";
  KeepTwoDrives(file_, true);
  KeepTwoDrives(second, true, "other_");
  EXPECT_EQ(Tool({"merge", file_, second, new_}), 0);
  EXPECT_TRUE(Printed("copied 48 frames, 4 sessions and 2 overlaps\n")) << printed_;
  EXPECT_EQ(Tool({"check", new_}), 0) << printed_;
  EXPECT_EQ(Tool({"prune", new_, "--images", "--descriptors"}), 0);
  EXPECT_TRUE(Printed("forgot 96 rows: ")) << printed_;
  EXPECT_THROW(Tool({"prune", new_}), std::runtime_error);
}

TEST_F(MapTool, ChangesNoStoreThatAnotherProcessMapsInto) {
  const std::string other = folder_.Path() / "running/map.db";
  const std::string link = folder_.Path() / "link.db";
  std::filesystem::create_directory(folder_.Path() / "running");
  KeepTwoDrives(file_, false);
  std::filesystem::create_symlink(file_, link);
  const FolderLock mapping(folder_.Path()), other_mapping(folder_.Path() / "running");
  const std::string before = ReadText(file_);
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"prune", file_, "--images"}, {"prune", link, "--images"}, {"repair", file_, other}}) {
    EXPECT_NE(MessageOf([&] { Tool(arguments); }).find("another process maps into this folder"),
              std::string::npos)
        << arguments[0];
  }
  EXPECT_EQ(ReadText(file_), before);
  EXPECT_FALSE(std::filesystem::exists(other));
  EXPECT_EQ(Tool({"repair", file_, new_}), 0) << printed_;  // reading is allowed
  EXPECT_EQ(Tool({"prune", new_, "--images"}), 0) << printed_;
}

TEST_F(MapTool, RefusesWhatItCannotUse) {
  const std::string folder = folder_.Path(), none = folder + "/none.db";
  const std::string pipe = folder + "/pipe.db";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info"}, {"check"}, {"prune", "--images"}}) {
    const auto message_of = [&](const std::string& file) {
      std::vector<std::string> arguments = words;
      arguments.insert(arguments.begin() + 1, file);
      return MessageOf([&] { Tool(arguments); });
    };
    EXPECT_EQ(message_of(none), none + ": cannot be opened: no such file");
    EXPECT_EQ(message_of(folder),
              folder + ": cannot be opened: is a folder; expected a map store (map.db)");
    EXPECT_EQ(message_of(pipe),
              pipe + ": cannot be opened: is no plain file; expected a map store (map.db)");
  }
  EXPECT_THROW(Tool({}), std::runtime_error);
  EXPECT_THROW(Tool({"nonsense"}), std::runtime_error);
  EXPECT_THROW(Tool({"merge", file_, file_}), std::runtime_error);
  for (const std::string command : {"info", "check"}) {
    EXPECT_NE(MessageOf([&] {
                Tool({command, file_});
              }).find(file_ + ": cannot be opened"),
              std::string::npos);
  }
  folder_.Write("map.db", "text");
  EXPECT_NE(MessageOf([&] {
              Tool({"info", file_});
            }).find(file_ + ": file is not a database"),
            std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
