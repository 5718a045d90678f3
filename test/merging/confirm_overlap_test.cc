#include "rovio_sfm/merging/confirm_overlap.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

struct Provisional {
  Provisional()
      : a(table.Adopt(MappedSession(two, false, {}))),
        b(table.Adopt(MappedSession(two, true, OtherGauge()))) {}

  MergeEdit Edit(uint32_t frame, const Sim3& b_from_a) {
    MergeEdit edit;
    edit.match = TrueOverlap(two, frame, frame);
    edit.links = LinksOf(edit.match, a.id(), b.id());
    edit.report.verdict = MergeVerdict::kProvisional;
    edit.report.query = edit.match.query;
    edit.report.other = edit.match.pairs[0].other;
    edit.report.other_session = a.id();
    edit.report.query_session = b.id();
    edit.report.query_from_other = b_from_a;
    return edit;
  }

  MergeOptions Loose() const {  // the synthetic frames all see much the same points
    MergeOptions options;
    options.max_shared_landmarks = 1.0;
    return options;
  }

  TwoDrives two = MakeTwoDrives();
  SessionTable table;
  Session &a, &b;
  MergeList list;
};

TEST(FindConfirmation, TakesAnOverlapThatSaysTheSame) {
  Provisional setup;
  setup.list.Keep(setup.Edit(2, OtherGauge()));
  const MergeEdit& edit = setup.list.Keep(setup.Edit(13, OtherGauge()));
  const MergeEdit* other = FindConfirmation(edit, setup.Loose(), setup.table, &setup.list);
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(other->report.id, 1u);
}

TEST(FindConfirmation, TakesOneSeenFromTheOtherSide) {
  Provisional setup;
  MergeEdit reversed = setup.Edit(2, Inverse(OtherGauge()));
  std::swap(reversed.report.query_session, reversed.report.other_session);
  std::swap(reversed.report.query, reversed.report.other);
  setup.list.Keep(reversed);
  const MergeEdit& edit = setup.list.Keep(setup.Edit(13, OtherGauge()));
  EXPECT_NE(FindConfirmation(edit, setup.Loose(), setup.table, &setup.list), nullptr);
}

TEST(FindConfirmation, RefusesAnotherScaleAndTheSameLandmarks) {
  Provisional setup;
  Sim3 larger = OtherGauge();
  larger.scale *= 1.2;
  setup.list.Keep(setup.Edit(2, larger));
  const MergeEdit& other = setup.list.Keep(setup.Edit(13, OtherGauge()));
  EXPECT_EQ(FindConfirmation(other, setup.Loose(), setup.table, &setup.list), nullptr);
  const MergeEdit& same = setup.list.Keep(setup.Edit(13, OtherGauge()));
  EXPECT_EQ(FindConfirmation(same, {}, setup.table, &setup.list), nullptr);
}

TEST(MeasureLoop, SeesNoGapInATrueMap) {
  Provisional setup;
  MergeEdit merge = setup.Edit(8, OtherGauge());
  merge.report.verdict = MergeVerdict::kAccepted;
  setup.list.Keep(merge);
  setup.list.Place();
  const LoopStatement loop =
      MeasureLoop(setup.Edit(3, OtherGauge()).report, setup.list, setup.table);
  EXPECT_NEAR(loop.gap.distance, 0.0, 1e-9);
  EXPECT_TRUE(IsSmall(loop.gap, {}));
  EXPECT_GT(loop.way, 5.0);
}

}  // namespace
}  // namespace rovio_sfm
