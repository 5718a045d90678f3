#include "rovio_sfm/app/driver_options.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "rovio_sfm/app/option_reader.h"

namespace rovio_sfm {
namespace {

constexpr double kDegree = M_PI / 180.0;

void ReadSeconds(OptionReader* reader, const std::string& name, int64_t* value_ns) {
  double seconds = static_cast<double>(*value_ns) * 1e-9;
  reader->Read(name, &seconds);
  if (!(std::abs(seconds) < 1e6)) reader->Fail(name, "expected seconds");
  *value_ns = std::llround(seconds * 1e9);
}

void ReadDegrees(OptionReader* reader, const std::string& name, double* value_rad) {
  double degrees = *value_rad / kDegree;
  reader->Read(name, &degrees);
  *value_rad = degrees * kDegree;
}

template <typename T, size_t kSize>
void ReadArray(OptionReader* reader, const std::string& name, std::array<T, kSize>* values) {
  std::vector<T> list(values->begin(), values->end());
  reader->Read(name, &list);
  if (list.size() != kSize) {
    reader->Fail(name, "expected " + std::to_string(kSize) + " numbers");
  }
  std::copy(list.begin(), list.end(), values->begin());
}

// The value of `choices` whose name the parameter gives.
template <typename T>
void ReadChoice(OptionReader* reader, const std::string& name,
                const std::vector<std::pair<std::string, T>>& choices, T* value) {
  std::string wanted, expected = "expected one of";
  for (const auto& [choice, meaning] : choices) {
    if (meaning == *value) wanted = choice;
    expected += " " + choice;
  }
  reader->Read(name, &wanted);
  for (const auto& [choice, meaning] : choices) {
    if (choice != wanted) continue;
    *value = meaning;
    return;
  }
  reader->Fail(name, expected + ", not '" + wanted + "'");
}

void ReadHttp(OptionReader reader, CurlTransportOptions* http) {
  reader.Read("connect_timeout_s", &http->connect_timeout_s);
  reader.Read("first_byte_timeout_s", &http->first_byte_timeout_s);
  reader.Read("between_bytes_timeout_s", &http->between_bytes_timeout_s);
  reader.Read("total_timeout_s", &http->total_timeout_s);
  reader.Read("min_bytes_per_s", &http->min_bytes_per_s);
  reader.Read("min_speed_window_s", &http->min_speed_window_s);
  reader.RefuseUnknown();
}

void ReadImages(OptionReader reader, ImageReaderOptions* images) {
  ReadChoice<ImageSource>(&reader, "source",
                          {{"auto", ImageSource::kAuto},
                           {"stream", ImageSource::kStream},
                           {"stills", ImageSource::kStills}},
                          &images->source);
  uint64_t max_bytes = images->parser.max_part_bytes, max_pixels = images->max_pixels;
  reader.Read("max_bytes", &max_bytes);
  reader.Read("max_pixels", &max_pixels);
  images->parser.max_part_bytes = max_bytes;
  images->max_pixels = max_pixels;
  reader.Read("max_stream_failures", &images->max_stream_failures);
  reader.Read("max_image_gap_s", &images->max_image_gap_s);
  reader.Read("stream_retry_period_s", &images->stream_retry_period_s);
  reader.RefuseUnknown();
}

BackOffOptions ReadBackOff(OptionReader reader) {
  BackOffOptions back_off;
  reader.Read("first_delay_s", &back_off.first_delay_s);
  reader.Read("max_delay_s", &back_off.max_delay_s);
  reader.Read("factor", &back_off.factor);
  reader.RefuseUnknown();
  return back_off;
}

std::optional<CameraSettings> ReadCamera(OptionReader reader) {
  CameraSettings settings;
  bool configure = true;
  reader.Read("configure", &configure);
  reader.Read("resolution", &settings.resolution);
  reader.Read("compression", &settings.compression);
  reader.Read("frame_rate", &settings.frame_rate);
  reader.Read("brightness", &settings.brightness);
  reader.RefuseUnknown();
  return configure ? std::optional<CameraSettings>(settings) : std::nullopt;
}

void ReadDrive(OptionReader reader, DriveOptions* drive) {
  ReadArray(&reader, "speed_m_per_s", &drive->speed_m_per_s);
  ReadArray(&reader, "turn_rad_per_s", &drive->turn_rad_per_s);
  reader.Read("min_speed_m_per_s", &drive->min_speed_m_per_s);
  reader.Read("min_turn_rad_per_s", &drive->min_turn_rad_per_s);
  reader.Read("turn_radius_m", &drive->turn_radius_m);
  ReadSeconds(&reader, "repeat_period_s", &drive->repeat_period_ns);
  ReadSeconds(&reader, "cmd_vel_timeout_s", &drive->max_command_age_ns);
  reader.RefuseUnknown();
}

void ReadOdometry(OptionReader reader, OmniOdometryOptions* odometry) {
  reader.Read("wheel_distance_m", &odometry->wheel_distance_m);
  ReadDegrees(&reader, "front_roll_angle_deg", &odometry->front_roll_angle_rad);
  reader.Read("ticks_per_m", &odometry->ticks_per_m);
  ReadArray(&reader, "wheel_sign", &odometry->wheel_sign);
  reader.Read("forward_scale", &odometry->forward_scale);
  reader.Read("sideways_scale", &odometry->sideways_scale);
  reader.Read("rotation_scale", &odometry->rotation_scale);
  reader.Read("forward_gain_sigma", &odometry->forward_gain_sigma);
  reader.Read("sideways_gain_sigma", &odometry->sideways_gain_sigma);
  reader.Read("rotation_gain_sigma", &odometry->rotation_gain_sigma);
  reader.Read("forward_noise_m_per_sqrt_m", &odometry->forward_noise_m_per_sqrt_m);
  reader.Read("sideways_noise_m_per_sqrt_m", &odometry->sideways_noise_m_per_sqrt_m);
  reader.Read("rotation_noise_rad_per_sqrt_rad", &odometry->rotation_noise_rad_per_sqrt_rad);
  reader.Read("heading_noise_rad_per_sqrt_m", &odometry->heading_noise_rad_per_sqrt_m);
  reader.Read("tick_sigma", &odometry->tick_sigma);
  reader.Read("lost_report_speed_m_per_s", &odometry->lost_report_speed_m_per_s);
  reader.RefuseUnknown();
}

void ReadHead(OptionReader reader, HeadGeometryOptions* head) {
  reader.Read("camera_forward_m", &head->camera_forward_m);
  reader.Read("camera_left_m", &head->camera_left_m);
  reader.Read("camera_height_down_m", &head->camera_height_down_m);
  reader.Read("camera_height_up_m", &head->camera_height_up_m);
  ReadDegrees(&reader, "camera_pitch_deg", &head->camera_pitch_rad);
  reader.Read("head_position_down", &head->head_position_down);
  reader.Read("head_position_up", &head->head_position_up);
  reader.RefuseUnknown();
}

void ReadFrames(OptionReader* reader, const std::string& robot, DriverFrames* frames) {
  const auto read = [&](const char* parameter, const char* name, std::string* frame) {
    reader->Read(parameter, frame);
    if (frame->empty()) *frame = robot.empty() ? name : robot + "/" + name;
  };
  read("odom_frame_id", "odom", &frames->odom);
  read("base_frame_id", "base_link", &frames->base);
  read("camera_link_frame_id", "camera_link", &frames->camera_link);
  read("frame_id", "camera_optical", &frames->camera_optical);
}

void ReadTop(OptionReader* reader, DriverOptions* options) {
  reader->Read("host", &options->http.host);
  reader->Read("port", &options->http.port);
  reader->Read("credentials_file", &options->credentials_file);
  ReadChoice<CaptureMode>(
      reader, "capture_mode",
      {{"stream", CaptureMode::kStream}, {"stationary", CaptureMode::kStationary}},
      &options->capture_mode);
  reader->Read("image_latency_s", &options->image_latency_s);
  reader->Read("publish_tf", &options->publish_tf);
  reader->Read("camera_name", &options->camera_name);
  reader->Read("camera_info_url", &options->camera_info_url);
  reader->Read("mcu_rate_hz", &options->mcu_rate_hz);
  reader->Read("report_rate_hz", &options->report_rate_hz);
  ReadSeconds(reader, "stationary_rest_s", &options->stationary.rest_ns);
  double diagnostic_period_s = 1.0;  // diagnostic_updater reads it itself
  reader->Read("diagnostic_period", &diagnostic_period_s);
}

}  // namespace

bool DriverOptions::IsValid(std::string* error) const {
  if (!(image_latency_s >= 0.0 && image_latency_s <= 1.0)) {
    *error = "image_latency_s must be 0 … 1";
  } else if (!(mcu_rate_hz >= 1.0 && mcu_rate_hz <= 50.0)) {
    *error = "mcu_rate_hz must be 1 … 50";
  } else if (!(report_rate_hz >= 0.1 && report_rate_hz <= 10.0)) {
    *error = "report_rate_hz must be 0.1 … 10";
  } else {
    return http.IsValid(error) && images.IsValid(error) && reports.IsValid(error) &&
           drive.IsValid(error) && odometry.IsValid(error) && head.IsValid(error) &&
           stationary.IsValid(error);
  }
  return false;
}

DriverOptions LoadDriverOptions(const YAML::Node& parameters, const std::string& robot) {
  DriverOptions options;
  OptionReader reader(parameters, "rovio_driver");
  ReadTop(&reader, &options);
  ReadFrames(&reader, robot, &options.frames);
  ReadHttp(reader.Group("http"), &options.http);
  ReadImages(reader.Group("images"), &options.images);
  options.images.back_off = ReadBackOff(reader.Group("back_off"));
  options.reports.back_off = options.images.back_off;
  options.reports.wanted_settings = ReadCamera(reader.Group("camera"));
  ReadDrive(reader.Group("drive"), &options.drive);
  ReadOdometry(reader.Group("odometry"), &options.odometry);
  ReadHead(reader.Group("head"), &options.head);
  reader.RefuseUnknown();
  std::string error;
  if (!options.IsValid(&error)) throw std::runtime_error("rovio_driver: " + error);
  return options;
}

}  // namespace rovio_sfm
