#include "rovio_sfm/ros/merge_report_message.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(MergeReportMessage, SaysWhatAndWhy) {
  MergeReport report;
  report.id = 7;
  report.kind = MergeKind::kLoop;
  report.verdict = MergeVerdict::kProvisional;
  report.accepted_by = AcceptedBy::kSecondOverlap;
  report.reason = "the inliers lie on one plane";
  report.query = {{"rovio2", 5000000000, 3}, 11};
  report.query_session = {2};
  report.other_session = {1};
  report.num_inliers = 40;
  report.query_from_other = {2.5, Eigen::Quaterniond::Identity(), {1.0, 2.0, 3.0}};
  report.error_after_px = 0.5;
  const MergeReportMsg message = ToMessage(report);
  EXPECT_EQ(message.id, 7u);
  EXPECT_EQ(message.kind, MergeReportMsg::LOOP);
  EXPECT_EQ(message.verdict, MergeReportMsg::PROVISIONAL);
  EXPECT_EQ(message.reason, report.reason);
  EXPECT_EQ(message.accepted_by, MergeReportMsg::SECOND_OVERLAP);
  EXPECT_EQ(message.query.drive.robot, "rovio2");
  EXPECT_EQ(message.query.index, 11u);
  EXPECT_EQ(message.query_session, 2u);
  EXPECT_EQ(message.other_session, 1u);
  EXPECT_EQ(message.num_inliers, 40u);
  EXPECT_EQ(message.query_from_other.translation.z, 3.0);
  EXPECT_EQ(message.scale, 2.5);
  EXPECT_EQ(message.error_after_px, 0.5);
}

TEST(MergeReportMessage, ConstantsOfTheMessageAreThoseOfTheCore) {
  EXPECT_EQ(MergeReportMsg::MERGE, static_cast<uint8_t>(MergeKind::kMerge));
  EXPECT_EQ(MergeReportMsg::SEED, static_cast<uint8_t>(MergeKind::kSeed));
  EXPECT_EQ(MergeReportMsg::NOBODY, static_cast<uint8_t>(AcceptedBy::kNobody));
  EXPECT_EQ(MergeReportMsg::HAND, static_cast<uint8_t>(AcceptedBy::kHand));
  EXPECT_EQ(MergeReportMsg::WAITING, static_cast<uint8_t>(MergeVerdict::kWaiting));
  EXPECT_EQ(MergeReportMsg::ACCEPTED, static_cast<uint8_t>(MergeVerdict::kAccepted));
  EXPECT_EQ(MergeReportMsg::REFUSED, static_cast<uint8_t>(MergeVerdict::kRefused));
  EXPECT_EQ(MergeReportMsg::UNDONE, static_cast<uint8_t>(MergeVerdict::kUndone));
}

}  // namespace
}  // namespace rovio_sfm
