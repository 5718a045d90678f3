#include "rovio_sfm/merging/confirm_overlap.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

struct Provisional {
  Provisional() : a(MappedSession(two, false, {})), b(MappedSession(two, true, OtherGauge())) {
    table.Add(&a);
    table.Add(&b);
  }

  MergeRecord Record(uint32_t frame, const Sim3& b_from_a) {
    MergeRecord record;
    record.match = TrueOverlap(two, frame, frame);
    record.links = LinksOf(record.match, a.id(), b.id());
    record.report.verdict = MergeVerdict::kProvisional;
    record.report.query = record.match.query;
    record.report.other = record.match.pairs[0].other;
    record.report.other_session = a.id();
    record.report.query_session = b.id();
    record.report.query_from_other = b_from_a;
    return record;
  }

  MergeOptions Loose() const {  // the synthetic frames all see much the same points
    MergeOptions options;
    options.max_shared_landmarks = 1.0;
    return options;
  }

  TwoDrives two = MakeTwoDrives();
  Session a, b;
  SessionTable table;
  MergeLedger ledger;
};

TEST(FindConfirmation, TakesAnOverlapThatSaysTheSame) {
  Provisional setup;
  setup.ledger.Keep(setup.Record(2, OtherGauge()));
  const MergeRecord& record = setup.ledger.Keep(setup.Record(13, OtherGauge()));
  const MergeRecord* other = FindConfirmation(record, setup.Loose(), setup.table, &setup.ledger);
  ASSERT_NE(other, nullptr);
  EXPECT_EQ(other->report.id, 1u);
}

TEST(FindConfirmation, TakesOneSeenFromTheOtherSide) {
  Provisional setup;
  MergeRecord reversed = setup.Record(2, Inverse(OtherGauge()));
  std::swap(reversed.report.query_session, reversed.report.other_session);
  std::swap(reversed.report.query, reversed.report.other);
  setup.ledger.Keep(reversed);
  const MergeRecord& record = setup.ledger.Keep(setup.Record(13, OtherGauge()));
  EXPECT_NE(FindConfirmation(record, setup.Loose(), setup.table, &setup.ledger), nullptr);
}

TEST(FindConfirmation, RefusesAnotherScaleAndTheSameLandmarks) {
  Provisional setup;
  Sim3 larger = OtherGauge();
  larger.scale *= 1.2;
  setup.ledger.Keep(setup.Record(2, larger));
  const MergeRecord& other = setup.ledger.Keep(setup.Record(13, OtherGauge()));
  EXPECT_EQ(FindConfirmation(other, setup.Loose(), setup.table, &setup.ledger), nullptr);
  const MergeRecord& same = setup.ledger.Keep(setup.Record(13, OtherGauge()));
  EXPECT_EQ(FindConfirmation(same, {}, setup.table, &setup.ledger), nullptr);
}

TEST(MeasureLoop, SeesNoGapInATrueMap) {
  Provisional setup;
  MergeRecord merge = setup.Record(8, OtherGauge());
  merge.report.verdict = MergeVerdict::kAccepted;
  setup.ledger.Keep(merge);
  setup.ledger.Place();
  const LoopStatement loop =
      MeasureLoop(setup.Record(3, OtherGauge()).report, setup.ledger, setup.table);
  EXPECT_NEAR(loop.gap.distance, 0.0, 1e-9);
  EXPECT_TRUE(IsSmall(loop.gap, {}));
  EXPECT_GT(loop.way, 5.0);
}

}  // namespace
}  // namespace rovio_sfm
