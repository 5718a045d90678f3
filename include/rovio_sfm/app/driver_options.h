#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "rovio_sfm/rovio/curl_transport.h"
#include "rovio_sfm/rovio/drive_command.h"
#include "rovio_sfm/rovio/head_geometry.h"
#include "rovio_sfm/rovio/image_reader.h"
#include "rovio_sfm/rovio/omni_odometry.h"
#include "rovio_sfm/rovio/robot_reporter.h"
#include "rovio_sfm/rovio/stationary_trigger.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

enum class CaptureMode { kStream, kStationary };

// Names of tf frames; empty ones become <robot>/odom and so on, <robot> being the namespace.
struct DriverFrames {
  std::string odom;
  std::string base;
  std::string camera_link;
  std::string camera_optical;

  void DescribeOptions(OptionTable& table) {
    table.AddText("frame_id", camera_optical, "tf frame; empty: <namespace>/camera_optical");
    table.AddText("odom_frame_id", odom, "empty: <namespace>/odom");
    table.AddText("base_frame_id", base, "empty: <namespace>/base_link");
    table.AddText("camera_link_frame_id", camera_link, "empty: <namespace>/camera_link");
  }
};

// What the robot's camera is asked for.
struct WantedCamera {
  bool configure = true;
  CameraSettings settings;

  void DescribeOptions(OptionTable& table) {
    table.AddFlag("configure", configure, "false: leave the robot's settings alone");
    settings.DescribeOptions(table);
  }
};

// Everything that can be set about the driver.
struct DriverOptions {
  CurlTransportOptions http;
  std::string credentials_file;
  CaptureMode capture_mode = CaptureMode::kStream;
  double image_latency_s = 0.0;
  bool publish_tf = true;
  std::string camera_name;
  std::string camera_info_url = "package://rovio_sfm/config/camera/rovio_640x480.yaml";
  double mcu_rate_hz = 20.0;
  double report_rate_hz = 1.0;
  double diagnostic_period = 1.0;  // diagnostic_updater reads it itself
  DriverFrames frames;
  WantedCamera camera;
  ImageReaderOptions images;
  ReporterOptions reports;
  DriveOptions drive;
  OmniOdometryOptions odometry;
  HeadGeometryOptions head;
  StationaryOptions stationary;

  void DescribeOptions(OptionTable& table);
};

// Reads the options of a driver in the namespace `robot`. Throws std::runtime_error that names the
// parameter: unknown, of a wrong type or out of range.
DriverOptions LoadDriverOptions(const YAML::Node& parameters, const std::string& robot);

}  // namespace rovio_sfm
