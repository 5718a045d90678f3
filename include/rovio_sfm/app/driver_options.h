#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "rovio_sfm/rovio/curl_transport.h"
#include "rovio_sfm/rovio/drive_command.h"
#include "rovio_sfm/rovio/head_geometry.h"
#include "rovio_sfm/rovio/image_reader.h"
#include "rovio_sfm/rovio/omni_odometry.h"
#include "rovio_sfm/rovio/robot_reporter.h"
#include "rovio_sfm/rovio/stationary_trigger.h"

namespace rovio_sfm {

enum class CaptureMode { kStream, kStationary };

// Names of tf frames; empty ones become <robot>/odom and so on, <robot> being the namespace.
struct DriverFrames {
  std::string odom;
  std::string base;
  std::string camera_link;
  std::string camera_optical;
};

// Everything that can be set about the driver; mirrors config/rovio_driver.yaml.
struct DriverOptions {
  CurlTransportOptions http;
  std::string credentials_file;  // two lines, user and password; empty: none
  CaptureMode capture_mode = CaptureMode::kStream;
  double image_latency_s = 0.0;  // an image was taken so long before its first byte came; 0 to 1
  bool publish_tf = true;
  std::string camera_name = "rovio_640x480";
  std::string camera_info_url = "package://rovio_sfm/config/camera/rovio_640x480.yaml";
  double mcu_rate_hz = 20.0;    // of tick readings; slower ones lose ticks to the robot itself
  double report_rate_hz = 1.0;  // of battery, settings, signals
  DriverFrames frames;
  ImageReaderOptions images;
  ReporterOptions reports;
  DriveOptions drive;
  OmniOdometryOptions odometry;
  HeadGeometryOptions head;
  StationaryOptions stationary;

  bool IsValid(std::string* error) const;
};

// Reads the options of a driver in the namespace `robot`. Throws std::runtime_error that names the
// parameter: unknown, of a wrong type or out of range.
DriverOptions LoadDriverOptions(const YAML::Node& parameters, const std::string& robot);

}  // namespace rovio_sfm
