#include "rovio_sfm/report/page_data.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/small_snapshot.h"

namespace rovio_sfm {
namespace {

LevelMap SmallMap() {
  MapSnapshot snapshot;
  snapshot.sessions.push_back(SmallSession(1, 4, {SmallLandmark(1, 4, 0.001)}));
  return *FindLargestMap(snapshot);
}

// Two images, and two points that both see; the second feature is 0.01 off: 5 px of 500.
MapModel SmallModel() {
  MapModel model;
  model.length_unit = "map units";
  model.cameras.push_back({500.0, 500.0, 320.0, 240.0, 0, 0, 0, 0, 0, 640, 480});
  for (uint32_t i = 0; i < 2; ++i) {
    ModelImage image;
    image.id = {{"rovio1", 5, 6}, i};
    image.keypoints.resize(2);
    image.keypoints[1].x_normalized = {0.01, 0.0};
    model.images.push_back(image);
  }
  for (uint32_t i = 0; i < 2; ++i) {
    ModelPoint point;
    point.x_in_map = {0.0, 0.0, 2.0};
    point.views = {{0, i}, {1, i}};
    model.points.push_back(point);
  }
  return model;
}

nlohmann::json Page(const PageNotes& notes = {}, const PointCloud* dense = nullptr,
                    const TriangleMesh* mesh = nullptr) {
  return nlohmann::json::parse(PageDataJson(SmallMap(), SmallModel(), notes, dense, mesh));
}

TEST(PageDataJson, TellsTracksErrorsAndPaths) {
  const auto page = Page();
  EXPECT_EQ(page["tracks"][0], 2);  // of two views
  EXPECT_NEAR(page["errors"][0].get<double>(), 2.5, 1e-3);
  EXPECT_EQ(page["views"], nlohmann::json({2, 2}));
  ASSERT_EQ(page["paths"].size(), 1u);
  EXPECT_EQ(page["paths"][0]["poses"].size(), page["paths"][0]["keyframes"].size());
  EXPECT_EQ(page["unit"], "map units");
  EXPECT_EQ(page["warnings"].size(), 1u);  // that it is not metric
}

TEST(PageDataJson, HasTheRowsThatAreNoted) {
  PageNotes notes;
  notes.figures = {{"densified points", "5 → 9"}};
  const auto figures = Page(notes)["figures"];
  EXPECT_EQ(figures["densified points"], "5 → 9");
  EXPECT_EQ(figures.size(), Page()["figures"].size() + 1);
}

TEST(PageDataJson, ArraysAreBase64OfLittleEndianNumbers) {
  PointCloud dense(1);
  dense[0].position = {1.0f, 0.0f, 0.0f};
  dense[0].color = {255, 0, 1};
  const auto page = Page({}, &dense);
  EXPECT_EQ(page["dense"]["count"], 1);
  EXPECT_EQ(page["dense"]["positions"], "AACAPwAAAAAAAAAA");
  EXPECT_EQ(page["dense"]["colors"], "/wAB");
  EXPECT_TRUE(page["mesh"].is_null());
}

TEST(PageDataJson, ThinsWhatIsTooMuchAndLeavesOutAHugeMesh) {
  PointCloud dense(kMaxPagePoints * 3);
  TriangleMesh mesh;
  mesh.vertices.resize(3);
  mesh.triangles.assign(kMaxPageTriangles + 1, {0, 1, 2});
  const auto page = Page({}, &dense, &mesh);
  EXPECT_LE(page["dense"]["count"], kMaxPagePoints);
  EXPECT_GT(page["dense"]["count"], kMaxPagePoints / 2);
  EXPECT_TRUE(page["mesh"].is_null());
  EXPECT_EQ(page["warnings"].size(), 2u);
}

TEST(PageDataJson, OverlapsLeadFromCameraToCamera) {
  PageNotes notes;
  MergeReport merge;
  merge.query = {{"rovio1", 5, 6}, 0}, merge.other = {{"rovio1", 5, 6}, 1};
  merge.verdict = MergeVerdict::kAccepted;
  merge.accepted_by = AcceptedBy::kRequest;
  notes.merges = {merge, merge, merge};
  notes.merges[1].verdict = MergeVerdict::kRefused;
  notes.merges[2].other.index = 7;  // not of this map
  const auto page = Page(notes);
  EXPECT_EQ(page["overlaps"].size(), 1u);
  EXPECT_EQ(page["merges"].size(), 3u);
  EXPECT_EQ(page["merges"][0]["accepted_by"], "request");
}

TEST(PageDataJson, BearsTextThatIsNotUtf8) {
  PageNotes notes;
  notes.warnings = {"caf\xe9"};
  EXPECT_EQ(Page(notes)["warnings"].size(), 2u);
}

}  // namespace
}  // namespace rovio_sfm
