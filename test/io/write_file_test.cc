#include "rovio_sfm/io/write_file.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <vector>

#include "rovio_sfm/io/text_file.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

std::string Content(const std::filesystem::path& path) {
  const auto bytes = ReadBytes(path, 1000);
  return {bytes.begin(), bytes.end()};
}

size_t NumFiles(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator files(folder);
  return static_cast<size_t>(std::distance(begin(files), end(files)));
}

TEST(WriteFile, RefusesToReplaceUnlessAllowed) {
  const TemporaryFolder folder;
  const auto path = folder.Path() / "a.txt";
  WriteFile(path, "one", Overwrite::kRefuse);
  EXPECT_NE(MessageOf([&] { WriteFile(path, "two", Overwrite::kRefuse); }).find("a.txt"),
            std::string::npos);
  EXPECT_EQ(Content(path), "one");
  WriteFile(path, "three", Overwrite::kAllow);
  EXPECT_EQ(Content(path), "three");
  EXPECT_EQ(NumFiles(folder.Path()), 1u);
}

TEST(WriteFile, LeavesNothingBehindWhereItFails) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.Path() / "is_a_folder");
  folder.Write("is_a_folder/x", "");
  EXPECT_NE(MessageOf([&] { WriteFile(folder.Path() / "is_a_folder", "x", Overwrite::kAllow); }),
            "");
  EXPECT_EQ(NumFiles(folder.Path()), 1u);
  EXPECT_NE(MessageOf([&] { WriteFile(folder.Path() / "no/such", "x", Overwrite::kAllow); }), "");
}

// A folder in memory that knows what a loss of power may leave of it: contents are there once they
// are synced, names once the folder is. One call may fail.
class RecordingFiles final : public FileLayer {
 public:
  using Names = std::map<std::string, std::string>;  // to contents

  explicit RecordingFiles(Names files, int failing = -1)
      : names_(files), durable_(std::move(files)), failing_(failing) {}

  bool Exists(const std::filesystem::path& path) override {
    Count(path);
    return names_.count(path) != 0;
  }
  void WriteAndSync(const std::filesystem::path& path, const std::string& content) override {
    Change(path, content.substr(0, content.size() / 2));
    Count(path);
    Change(path, content);
  }
  void Rename(const std::filesystem::path& from, const std::filesystem::path& to) override {
    Count(to);
    const std::string content = names_.at(from);
    names_.erase(from);
    names_[to] = content;
    // One change of the folder: both names, or neither.
    pending_.push_back([from, to, content](Names* names) {
      names->erase(from);
      (*names)[to] = content;
    });
    Crash();
  }
  void Link(const std::filesystem::path& from, const std::filesystem::path& to) override {
    Count(to);
    if (names_.count(to) != 0) throw std::runtime_error(to.string() + ": exists");
    Change(to, names_.at(from));
  }
  void Remove(const std::filesystem::path& path) noexcept override {
    names_.erase(path);
    pending_.push_back([path](Names* names) { names->erase(path); });
    Crash();
  }
  void SyncFolder(const std::filesystem::path& folder) override {
    Count(folder);
    durable_ = names_;
    pending_.clear();
    Crash();
  }

  const Names& names() const { return names_; }
  int num_calls() const { return num_calls_; }
  // What each crash so far might have left: any of the changes since the folder was synced.
  const std::vector<Names>& crashes() const { return crashes_; }

 private:
  void Count(const std::filesystem::path& path) {
    if (num_calls_++ == failing_) throw std::runtime_error(path.string() + ": input/output error");
  }
  void Change(const std::string& path, const std::string& content) {
    names_[path] = content;
    pending_.push_back([path, content](Names* names) { (*names)[path] = content; });
    Crash();
  }
  void Crash() {
    for (uint32_t kept = 0; kept < 1u << pending_.size(); ++kept) {
      Names left = durable_;
      for (size_t i = 0; i < pending_.size(); ++i) {
        if ((kept >> i & 1) != 0) pending_[i](&left);
      }
      crashes_.push_back(std::move(left));
    }
  }

  Names names_, durable_;
  std::vector<std::function<void(Names*)>> pending_;
  std::vector<Names> crashes_;
  const int failing_;
  int num_calls_ = 0;
};

TEST(WriteFile, LeavesTheOldOrTheNewContentWheneverThePowerFails) {
  for (const Overwrite overwrite : {Overwrite::kAllow, Overwrite::kRefuse}) {
    const bool replaces = overwrite == Overwrite::kAllow;
    RecordingFiles::Names before = {{"a/other", "other"}};
    if (replaces) before["a/map"] = "old";
    RecordingFiles files(before);
    WriteFile("a/map", "newer", overwrite, files);
    EXPECT_GT(files.crashes().size(), 10u);
    for (const RecordingFiles::Names& left : files.crashes()) {
      const auto map = left.find("a/map");
      const std::string content = map == left.end() ? "none" : map->second;
      EXPECT_TRUE(content == "newer" || content == (replaces ? "old" : "none")) << content;
      EXPECT_EQ(left.at("a/other"), "other");
    }
    EXPECT_EQ(files.crashes().back().at("a/map"), "newer");  // it has returned: nothing is pending
    EXPECT_EQ(files.names().size(), 2u);
  }
}

TEST(WriteFile, KeepsTheOldContentWhereAnyCallFails) {
  RecordingFiles whole(RecordingFiles::Names{{"a/map", "old"}});
  WriteFile("a/map", "newer", Overwrite::kAllow, whole);
  for (int failing = 0; failing < whole.num_calls(); ++failing) {
    RecordingFiles files(RecordingFiles::Names{{"a/map", "old"}}, failing);
    const std::string error =
        MessageOf([&] { WriteFile("a/map", "newer", Overwrite::kAllow, files); });
    EXPECT_EQ(error.rfind("a", 0), 0u) << error;
    EXPECT_NE(error.find(": input/output error"), std::string::npos) << error;
    const bool is_named = failing == whole.num_calls() - 1;  // the folder could not be synced
    EXPECT_EQ(files.names(), (RecordingFiles::Names{{"a/map", is_named ? "newer" : "old"}}));
  }
  EXPECT_EQ(whole.num_calls(), 3);
}

}  // namespace
}  // namespace rovio_sfm
