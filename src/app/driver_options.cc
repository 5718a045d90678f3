#include "rovio_sfm/app/driver_options.h"

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {
namespace {

void CompleteFrames(const std::string& robot, DriverFrames* frames) {
  const auto complete = [&](const char* name, std::string* frame) {
    if (frame->empty()) *frame = robot.empty() ? name : robot + "/" + name;
  };
  complete("odom", &frames->odom);
  complete("base_link", &frames->base);
  complete("camera_link", &frames->camera_link);
  complete("camera_optical", &frames->camera_optical);
}

}  // namespace

void DriverOptions::DescribeOptions(OptionTable& table) {
  http.DescribeAddress(table);
  table.AddText("credentials_file", credentials_file, "two lines, user and password; mode 0600");
  table.AddChoice("capture_mode", capture_mode,
                  {{"stream", CaptureMode::kStream}, {"stationary", CaptureMode::kStationary}},
                  "stream: every image; stationary: one per stop, wheels at rest");
  stationary.DescribeOptions(table);
  table.AddNumber("image_latency_s", image_latency_s, 0.0, 1.0,
                  "an image was taken so long before its first byte came");
  table.AddFlag("publish_tf", publish_tf, "");
  frames.DescribeOptions(table);
  table.AddText("camera_name", camera_name, "names the calibration; empty: the robot's");
  table.AddText("camera_info_url", camera_info_url, "");
  table.AddNumber("mcu_rate_hz", mcu_rate_hz, 1.0, 50.0, "of ticks; slower ones lose some");
  table.AddNumber("report_rate_hz", report_rate_hz, 0.1, 10.0, "of battery, settings, signals");
  table.AddNumber("diagnostic_period", diagnostic_period, 0.1, 60.0, "s between two diagnostics");
  table.AddGroup("camera", camera, "what the robot's camera is asked for");
  table.AddGroup("http", static_cast<HttpLimits&>(http), "how long an answer may take");
  table.AddGroup("images", images, "");
  table.AddGroup("back_off", images.back_off, "between attempts that fail");
  table.AddGroup("drive", drive, "");
  table.AddGroup("odometry", odometry, "from the wheels' ticks");
  table.AddGroup("head", head, "where the camera is");
}

DriverOptions LoadDriverOptions(const YAML::Node& parameters, const std::string& robot) {
  DriverOptions options;
  LogOptions(LoadOptions(parameters, "rovio_driver", &options));
  CompleteFrames(robot, &options.frames);
  if (options.camera_name.empty()) options.camera_name = robot.empty() ? "rovio" : robot;
  options.reports.back_off = options.images.back_off;
  if (options.camera.configure) options.reports.wanted_settings = options.camera.settings;
  return options;
}

}  // namespace rovio_sfm
