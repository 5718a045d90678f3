#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

TEST(CameraCommands, AnswerNothingAndActOnlyOnGoodValues) {
  FaceFixture face;
  for (const char* target :
       {"/ChangeResolution.cgi?ResType=3", "/ChangeResolution.cgi?ResType=9",
        "/ChangeCompressRatio.cgi?Ratio=0", "/ChangeFramerate.cgi?Framerate=12",
        "/ChangeBrightness.cgi?Brightness=", "/ChangeSpeakerVolume.cgi?SpeakerVolume=31",
        "/ChangeMicVolume.cgi?MicVolume=x"}) {
    EXPECT_EQ(face.Status(target), 200);
    EXPECT_EQ(face.Ask(target), "") << target;
  }
  const RobotSettings settings = face.context.settings.Copy();
  EXPECT_EQ(settings.resolution, 9);
  EXPECT_EQ(settings.applied.resolution, 3);
  EXPECT_EQ(settings.applied.compression_ratio, 0);
  EXPECT_EQ(settings.applied.frame_rate_hz, 12);
  EXPECT_EQ(settings.brightness, 6);
  EXPECT_EQ(settings.speaker_volume, 31);
  EXPECT_EQ(settings.mic_volume, 0);
}

TEST(CameraCommands, AreRefusedToGuestsWithoutAWord) {
  FaceFixture face;
  face.caller = {"guest", Privilege::kUser};
  EXPECT_EQ(face.Status("/ChangeResolution.cgi?ResType=3"), 200);
  EXPECT_EQ(face.context.settings.Copy().resolution, 2);
}

TEST(CameraCommands, MainsFrequencyIsReadBack) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/GetCamera.cgi"), "Frequency = 50\n");
  face.Ask("/SetCamera.cgi?Frequency=60");
  face.Ask("/SetCamera.cgi?Frequency=55");
  EXPECT_EQ(face.Ask("/GetCamera.cgi"), "Frequency = 60\n");
}

TEST(CameraCommands, DropDataCountsStreams) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/DropData.cgi?Query=tag"), "Found = 0\n");
}

}  // namespace
}  // namespace rovio_sfm::sim
