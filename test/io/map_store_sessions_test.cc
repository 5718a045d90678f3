// The oracle is a session that lives on in memory: what is read back must have its content, and
// bear the same changes in the same way, marks and all.

#include "rovio_sfm/io/map_store_sessions.h"

#include <gtest/gtest.h>

#include "rovio_sfm/io/map_store_schema.h"
#include "scene/random_session.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

const DriveId kDrive{"rovio", 1, 0};
const FrameMaker kMake{[](const FrameEvent& event) { return BareKeyframe(event.id.index); },
                       [](const FrameEvent& event) { return BareLightFrame(event.id.index); }};

FrameEvent EventAt(uint32_t index) {
  FrameEvent event;
  event.id = {kDrive, index};
  event.camera = MakeSyntheticCamera();
  auto features = std::make_shared<FrameFeatures>();
  features->keypoints.resize(kNumFeatures);
  features->colors.resize(kNumFeatures);
  event.features = std::move(features);
  event.tracks.resize(kNumFeatures);
  return event;
}

// A file with the frames that random sessions are made of.
class StoreFile {
 public:
  explicit StoreFile(const std::filesystem::path& path)
      : database(path, StoreAccess::kCreate),
        frames((OpenSchema(StoreAccess::kCreate, &database), &database)),
        sessions(&database, &frames) {
    database.Execute("BEGIN");
    for (uint32_t i = 0; i < kNumFrames; ++i) frames.PutFrame(EventAt(i), false);
    database.Execute("COMMIT");
  }
  void Commit(Session* session) {
    database.Execute("BEGIN");
    sessions.Put(session);
    database.Execute("COMMIT");
  }

  StoreDatabase database;
  StoredFrames frames;
  StoredSessions sessions;
};

std::string BytesOf(double value) { return {reinterpret_cast<const char*>(&value), sizeof(value)}; }

std::string AllOf(const Session& session) {
  std::string all = ContentOf(session) + " state " + std::to_string(int(session.state()));
  if (session.scale()) all += session.scale()->source + std::to_string(session.scale()->sigma_log);
  if (session.odometry_delay())
    all += " delay " + std::to_string(session.odometry_delay()->delay_s);
  all += " fx " + std::to_string(session.camera().fx);
  for (const auto& [index, frame] : session.keyframes()) {
    for (const Eigen::Vector2d& point : frame.points)
      all += BytesOf(point.x()) + BytesOf(point.y());
    all += " " + std::to_string(frame.stamps.born) + "." + std::to_string(frame.stamps.moved);
  }
  for (const SessionEpoch& epoch : session.epochs()) {
    all += " mark " + std::to_string(epoch.number) + EpochBytes(epoch, {}) +
           std::to_string(epoch.camera.cx);
  }
  return all + std::to_string(session.num_marks());
}

Eigen::Vector3d AnyCorrection(Rng& rng) {
  const double focal = rng.Uniform(-1, 1), x = rng.Uniform(-1, 1), y = rng.Uniform(-1, 1);
  return {focal, x, y};
}

// One of two sessions that go through the same.
struct Twin {
  Session session{{1}, kDrive, MakeSyntheticCamera()};
  std::vector<uint32_t> marks;

  void Change(Rng rng) {
    MutateAtRandom(&session, rng);
    switch (rng.UniformInt(60)) {
      case 0:
      case 1:
        return marks.push_back(session.Mark());
      case 2:
        return session.set_scale({rng.Uniform(0.5, 2.0), 0.1, "odometry"});
      case 3:
        return session.set_odometry_delay(OdometryDelay{rng.Uniform(), 0.01});
      case 4:
        return session.set_state(SessionState::kMapping);
      case 5:
        return GoBack(rng);
      case 6:
        session.SetCamera(CorrectedCamera(session.given_camera(), 0.005 * AnyCorrection(rng)));
        return;
      default:
        return;
    }
  }
  void GoBack(Rng& rng) {
    if (marks.empty()) return;
    const size_t chosen = rng.UniformInt(static_cast<uint32_t>(marks.size()));
    session.RestoreTo(marks[chosen]);
    marks.resize(chosen);
  }
};

TEST(MapStoreSessions, GoOnAsIfTheyHadNeverBeenWritten) {
  size_t num_read = 0, num_landmarks = 0, num_epochs = 0;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const TemporaryFolder folder;
    Rng rng(seed);
    Twin unbroken, kept;
    auto file = std::make_unique<StoreFile>(folder.Path() / "map.db");
    for (int step = 0; step < 500; ++step) {
      const Rng change = rng.Fork(static_cast<uint64_t>(step));
      unbroken.Change(change);
      kept.Change(change);
      if (rng.UniformInt(8) == 0) file->Commit(&kept.session);
      if (rng.UniformInt(25) != 0) continue;
      file->Commit(&kept.session);
      file.reset();
      file = std::make_unique<StoreFile>(folder.Path() / "map.db");
      std::vector<SessionRecord> records = file->sessions.Read(kMake);
      ASSERT_EQ(records.size(), 1u);
      kept.session = Session(std::move(records[0]));
      ASSERT_EQ(AllOf(kept.session), AllOf(unbroken.session)) << "seed " << seed << " " << step;
      ASSERT_EQ(CheckInvariants(kept.session), "");
      ++num_read;
      num_landmarks += kept.session.landmarks().size();
      num_epochs += kept.session.epochs().size();
    }
    while (!unbroken.marks.empty()) {
      unbroken.session.RestoreTo(unbroken.marks.back());
      kept.session.RestoreTo(unbroken.marks.back());
      unbroken.marks.pop_back();
      ASSERT_EQ(ContentOf(kept.session), ContentOf(unbroken.session));
    }
  }
  EXPECT_GT(num_read, 50u);
  EXPECT_GT(num_landmarks, num_read);
  EXPECT_GT(num_epochs, num_read / 2);
}

class MapStoreSessionsRead : public ::testing::Test {
 protected:
  std::string ErrorAfter(const std::string& change) {
    Rng rng(7);
    Twin twin;
    for (int step = 0; step < 200; ++step) MutateAtRandom(&twin.session, rng);
    twin.session.Mark();
    for (int step = 0; step < 20; ++step) MutateAtRandom(&twin.session, rng);
    const TemporaryFolder folder;
    StoreFile file(folder.Path() / "map.db");
    file.Commit(&twin.session);
    file.database.Execute("PRAGMA foreign_keys = OFF;" + change);
    return MessageOf([&] {
      WithFileNamed(file.database.file(), [&] { return file.sessions.Read(kMake).size(); });
    });
  }
};

TEST_F(MapStoreSessionsRead, RefusesTablesThatContradictEachOther) {
  EXPECT_EQ(ErrorAfter(""), "");
  for (const auto& [change, expected] : std::initializer_list<std::pair<const char*, const char*>>{
           {"DELETE FROM keyframe_tracks WHERE rowid = 1", ": 0 tracks, expected 12"},
           {"DELETE FROM keyframe", "which is not there"},
           {"DELETE FROM frame WHERE id = (SELECT min(frame) FROM keyframe)", "is missing"},
           {"DELETE FROM drive", ""},  // read when the file was opened
           {"UPDATE session SET drive = 9", "drive 9 is missing"},
           {"UPDATE session SET state = 99", "session.state = 99: expected 0 to"},
           {"UPDATE keyframe SET pose = x'00'", "pose: cut short"},
           {"UPDATE light_pose SET pose = x'00'", "pose: cut short"},
           {"UPDATE landmark_block SET landmarks = x'00'", "landmarks: cut short"},
           {"UPDATE journal SET entries = x'00'", "journal: cut short"}}) {
    const std::string error = ErrorAfter(change);
    EXPECT_NE(error.find(expected), std::string::npos) << change << ": " << error;
  }
}

}  // namespace
}  // namespace rovio_sfm
