#include "rovio_sfm/io/calibration.h"

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr char kFreiburg1[] =
    "# fx fy cx cy k1 k2 p1 p2 k3 width height\n"
    "517.306408 516.469215 318.64304 255.313989 0.262383 -0.953104 -0.005358 0.002628 1.163314 640 "
    "480\n";

TEST(ReadCalibrationText, ReadsTheElevenNumbers) {
  const TemporaryFolder folder;
  const Camera camera = ReadCalibrationText(folder.Write("calibration.txt", kFreiburg1));
  EXPECT_EQ(camera.fy, 516.469215);
  EXPECT_EQ(camera.k3, 1.163314);
  EXPECT_EQ(camera.width, 640);
}

TEST(ReadCalibrationText, NamesTheFieldThatIsWrong) {
  const TemporaryFolder folder;
  const auto path = folder.Write("calibration.txt", "500 500 320 oops 0 0 0 0 0 640 480\n");
  const std::string message = MessageOf([&] { ReadCalibrationText(path); });
  EXPECT_NE(message.find("calibration.txt:1: field cy"), std::string::npos) << message;
  for (const char* text : {"", "1 2 3\n", "-5 500 320 240 0 0 0 0 0 640 480\n",
                           "500 500 320 240 0 0 0 0 0 640.5 480\n"}) {
    EXPECT_NE(MessageOf([&] { ReadCalibrationText(folder.Write("calibration.txt", text)); }), "")
        << text;
  }
}

TEST(ReadCalibrationText, RefusesACentreOutsideThePicture) {
  const TemporaryFolder folder;
  const auto path = folder.Write("calibration.txt", "500 500 9999 240 0 0 0 0 0 640 480\n");
  EXPECT_EQ(MessageOf([&] { ReadCalibrationText(path); }),
            path.string() + ":1: camera cx = 9999: expected 0 to 640 px, in the picture");
}

TEST(ReadCameraInfo, TakesSizesAsDecimalOnly) {
  const TemporaryFolder folder;
  const Camera camera = ReadCalibrationText(folder.Write("calibration.txt", kFreiburg1));
  std::string yaml = CameraInfoYaml(camera, "fr1");
  yaml.replace(yaml.find("640"), 3, "0640");
  const auto path = folder.Write("camera.yaml", yaml);
  EXPECT_EQ(MessageOf([&] { ReadCameraInfo(path); }),
            path.string() + ": key image_width: expected a whole number, not '0640'");
}

TEST(CameraInfo, RoundTrips) {
  const TemporaryFolder folder;
  const Camera camera = ReadCalibrationText(folder.Write("calibration.txt", kFreiburg1));
  EXPECT_EQ(ReadCameraInfo(folder.Write("camera.yaml", CameraInfoYaml(camera, "fr1"))), camera);
}

TEST(ReadCamera, TellsTheFormatByTheName) {
  const TemporaryFolder folder;
  const Camera camera = ReadCamera(folder.Write("calibration.txt", kFreiburg1));
  EXPECT_EQ(ReadCamera(folder.Write("camera.yml", CameraInfoYaml(camera, "fr1"))), camera);
}

TEST(ReadCameraInfo, TakesEightCoefficientsOfWhichTheLastAreZero) {
  const TemporaryFolder folder;
  const Camera camera = ReadCalibrationText(folder.Write("calibration.txt", kFreiburg1));
  std::string yaml = CameraInfoYaml(camera, "fr1");
  const size_t distortion = yaml.find("distortion_coefficients");
  yaml.insert(yaml.find(']', distortion), ", 0.0, 0.0, 0.0");
  EXPECT_EQ(ReadCameraInfo(folder.Write("camera.yaml", yaml)), camera);
  yaml.replace(yaml.find(", 0.0, 0.0, 0.0]", distortion), 5, ", 0.5");
  EXPECT_NE(MessageOf([&] { ReadCameraInfo(folder.Write("camera.yaml", yaml)); }), "");
}

TEST(ReadCameraInfo, NamesTheKeyThatIsWrong) {
  const TemporaryFolder folder;
  Camera camera;
  camera.fx = camera.fy = 500.0, camera.cx = 320.0, camera.cy = 240.0;
  camera.width = 640, camera.height = 480;
  std::string yaml = CameraInfoYaml(camera, "test");
  yaml.replace(yaml.find("plumb_bob"), 9, "fisheye");
  const std::string message = MessageOf([&] { ReadCameraInfo(folder.Write("camera.yaml", yaml)); });
  EXPECT_NE(message.find("distortion_model"), std::string::npos) << message;
  for (const char* text :
       {"", "[1, 2", "just text", "camera_matrix: 5\ndistortion_model: plumb_bob"}) {
    EXPECT_NE(MessageOf([&] { ReadCameraInfo(folder.Write("camera.yaml", text)); }), "") << text;
  }
}

}  // namespace
}  // namespace rovio_sfm
