#include "rovio_sfm/rovio/rovio_protocol.h"

#include <charconv>
#include <limits>
#include <map>

#include "rovio_sfm/rovio/header_value.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMcuBytes = 15;
constexpr size_t kMaxFields = 200;

using Fields = std::map<std::string, std::string, std::less<>>;

std::string NavTarget(int action) { return "/rev.cgi?Cmd=nav&action=" + std::to_string(action); }

std::optional<int> ParseInt(std::string_view text, int base = 10) {
  int value = 0;
  text = Trim(text);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// What stands behind "responses =" in a reply to Cmd=nav, to the end of the body.
std::optional<std::string_view> NavResponses(std::string_view body) {
  size_t at = 0;
  bool is_nav = false;
  while (at < body.size()) {
    const size_t end = std::min(body.find('\n', at), body.size());
    const std::string_view line = body.substr(at, end - at);
    const size_t equals = line.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const std::string_view name = Trim(line.substr(0, equals));
    if (name == "Cmd") is_nav = Trim(line.substr(equals + 1)) == "nav";
    if (name == "responses" && is_nav) return Trim(body.substr(at + equals + 1));
    at = end + 1;
  }
  return std::nullopt;
}

// The fields behind the code: name=value between bars, blanks and line ends round them.
Fields SplitFields(std::string_view responses) {
  Fields fields;
  size_t at = responses.find('|');
  while (at != std::string_view::npos && fields.size() < kMaxFields) {
    const size_t next = responses.find('|', at + 1);
    const std::string_view item = Trim(responses.substr(at + 1, next - at - 1));
    const size_t equals = item.find('=');
    if (equals != std::string_view::npos) {
      fields.emplace(Trim(item.substr(0, equals)), Trim(item.substr(equals + 1)));
    }
    at = next;
  }
  return fields;
}

// Reads integers out of fields and names those that it cannot read.
class FieldReader {
 public:
  explicit FieldReader(const Fields& fields) : fields_(fields) {}

  std::optional<int> Read(const char* name, int low, int high, int base = 10) {
    const auto it = fields_.find(name);
    if (it == fields_.end()) return NoteOdd(name, "is missing");
    const std::optional<int> value = ParseInt(it->second, base);
    if (!value) return NoteOdd(name, "is no number");
    if (*value < low || *value > high) return NoteOdd(name, "is out of range");
    return value;
  }

  const std::string& odd_fields() const { return odd_fields_; }

 private:
  std::optional<int> NoteOdd(const char* name, const char* what) {
    odd_fields_ += (odd_fields_.empty() ? "" : ", ") + (std::string(name) + " " + what);
    return std::nullopt;
  }

  const Fields& fields_;
  std::string odd_fields_;
};

std::optional<bool> BitOf(const std::optional<int>& flags, int bit) {
  if (!flags) return std::nullopt;
  return (*flags & bit) != 0;
}

RobotReport ReadReport(FieldReader& reader) {
  RobotReport report;
  report.state = reader.Read("state", 0, 255);
  report.signal_strength = reader.Read("ss", 0, 65535);
  const std::optional<int> flags = reader.Read("flags", 0, 0xFFFF, 16);
  report.home_saved = BitOf(flags, 1);
  report.obstacle = BitOf(flags, 2);
  report.infrared_on = BitOf(flags, 4);
  report.is_login_required = BitOf(reader.Read("user_check", 0, 1), 1);
  report.wifi_strength = reader.Read("wifi_ss", 0, 255);
  report.battery = reader.Read("battery", 0, 255);
  report.charging = reader.Read("charging", 0, 255);
  report.head_position = reader.Read("head_position", 0, 255);
  report.camera.brightness = reader.Read("brightness", 0, 255);
  report.camera.resolution = reader.Read("resolution", 0, 255);
  report.camera.compression = reader.Read("video_compression", 0, 255);
  report.camera.frame_rate = reader.Read("frame_rate", 0, 255);
  report.odd_fields = reader.odd_fields();
  return report;
}

std::optional<std::array<uint8_t, kMcuBytes>> ParseHexBytes(std::string_view text) {
  std::array<uint8_t, kMcuBytes> bytes{};
  if (text.size() != 2 * kMcuBytes) return std::nullopt;
  for (size_t i = 0; i < kMcuBytes; ++i) {
    const char* const digits = text.data() + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, bytes[i], 16);
    if (error != std::errc() || end != digits + 2) return std::nullopt;
  }
  return bytes;
}

}  // namespace

std::string ReportTarget() { return NavTarget(1); }
std::string McuReportTarget() { return NavTarget(20); }
std::string StopMotionTarget() { return NavTarget(33); }
std::string ResetStateTarget() { return NavTarget(17); }
std::string DockTarget() { return NavTarget(13); }
std::string HeadlightTarget(bool on) { return NavTarget(19) + "&LIGHT=" + (on ? "1" : "0"); }
std::string InfraredTarget(bool on) { return NavTarget(19) + "&IR=" + (on ? "1" : "0"); }
std::string StreamTarget() { return "/GetData.cgi"; }

std::string DriveTarget(DriveCode code, int speed) {
  const std::string target = NavTarget(18) + "&drive=" + std::to_string(static_cast<int>(code));
  return code == DriveCode::kStop ? target : target + "&speed=" + std::to_string(speed);
}

std::string HeadTarget(HeadPosition position) {
  const char* const drive = position == HeadPosition::kUp     ? "11"
                            : position == HeadPosition::kDown ? "12"
                                                              : "13";
  return NavTarget(18) + "&drive=" + drive;
}

std::string StillTarget(uint32_t number) {
  return "/Jpeg/CamImg" + std::to_string(number) + ".jpg";
}
std::string ResolutionTarget(int resolution) {
  return "/ChangeResolution.cgi?ResType=" + std::to_string(resolution);
}
std::string CompressionTarget(int compression) {
  return "/ChangeCompressRatio.cgi?Ratio=" + std::to_string(compression);
}
std::string FrameRateTarget(int frame_rate) {
  return "/ChangeFramerate.cgi?Framerate=" + std::to_string(frame_rate);
}
std::string BrightnessTarget(int brightness) {
  return "/ChangeBrightness.cgi?Brightness=" + std::to_string(brightness);
}

const char* DescribeNavCode(int code) {
  static constexpr std::array<const char*, 24> kWords = {"success",
                                                         "general failure",
                                                         "robot is busy",
                                                         "not implemented",
                                                         "unknown action",
                                                         "no NorthStar signal",
                                                         "path memory full",
                                                         "path read failed",
                                                         "base not set",
                                                         "path not found",
                                                         "path name missing",
                                                         "not recording",
                                                         "flash not ready",
                                                         "path not deleted",
                                                         "flash read failed",
                                                         "flash write failed",
                                                         "flash not ready",
                                                         "no memory",
                                                         "no MCU port",
                                                         "no NorthStar port",
                                                         "NorthStar check",
                                                         "UART error",
                                                         "parameter not in range",
                                                         "parameter missing"};
  return code >= 0 && code < static_cast<int>(kWords.size()) ? kWords[static_cast<size_t>(code)]
                                                             : "unknown code";
}

std::optional<int> ParseNavCode(std::string_view body) {
  const std::optional<std::string_view> responses = NavResponses(body);
  if (!responses) return std::nullopt;
  return ParseInt(responses->substr(0, responses->find('|')));
}

std::optional<RobotReport> ParseReport(std::string_view body, std::string* error) {
  const std::optional<std::string_view> responses = NavResponses(body);
  const std::optional<int> code = ParseNavCode(body);
  if (!code) {
    *error = "not a reply to Cmd=nav";
    return std::nullopt;
  }
  if (*code != 0) {
    *error = DescribeNavCode(*code);
    return std::nullopt;
  }
  const Fields fields = SplitFields(*responses);
  FieldReader reader(fields);
  return ReadReport(reader);
}

std::optional<McuReport> ParseMcuReport(std::string_view body, std::string* error) {
  const std::optional<std::string_view> responses = NavResponses(body);
  const auto bytes = responses ? ParseHexBytes(*responses) : std::nullopt;
  if (!bytes || (*bytes)[0] != kMcuBytes - 1) {
    *error = "not 15 bytes in hex that begin with 0E";
    return std::nullopt;
  }
  McuReport report;
  for (size_t wheel = 0; wheel < 3; ++wheel) {
    const size_t at = 2 + 3 * wheel;
    report.wheels[wheel].direction = (*bytes)[at];
    report.wheels[wheel].ticks =
        static_cast<uint16_t>((*bytes)[at + 1] * 256 + (*bytes)[at + 2]);  // big-endian
  }
  report.head_position = (*bytes)[12];
  report.battery = (*bytes)[13];
  const int status = (*bytes)[14];
  report.headlight_on = (status & 0x01) != 0;
  report.infrared_on = (status & 0x02) != 0;
  report.obstacle = (status & 0x04) != 0;
  report.is_charge_complete = (status & 0x08) != 0;
  report.is_charging = (status & 0x10) != 0;
  report.is_on_dock = (status & 0x40) != 0;
  return report;
}

}  // namespace rovio_sfm
