#include "rovio_sfm/app/camera_topics.h"

#include <map>
#include <set>
#include <stdexcept>

namespace rovio_sfm {
namespace {

constexpr char kCompressedEnd[] = "/compressed";
constexpr char kCompressed[] = "compressed";
constexpr char kRaw[] = "raw";

using Names = std::set<std::string>;

Names NamesOfType(const std::vector<PublishedTopic>& topics, const std::string& type) {
  Names names;
  for (const PublishedTopic& topic : topics) {
    if (topic.type == type) names.insert(topic.name);
  }
  return names;
}

// `argument` of the launch file chooses.
std::optional<std::string> TheOnlyOne(const Names& names, const std::string& type,
                                      const std::string& argument) {
  if (names.empty()) return std::nullopt;
  if (names.size() == 1) return *names.begin();
  std::string list;
  for (const std::string& name : names) list += " " + name;
  throw std::runtime_error("several topics of type " + type + ":" + list + "; choose one with " +
                           argument + ":=TOPIC");
}

// Base topic → its transports.
std::map<std::string, Names> ImageBases(const std::vector<PublishedTopic>& topics,
                                        const std::vector<std::string>& previews) {
  std::map<std::string, Names> bases;
  const std::string end = kCompressedEnd;
  for (const std::string& name : NamesOfType(topics, "sensor_msgs/Image")) {
    bases[name].insert(kRaw);
  }
  for (const std::string& name : NamesOfType(topics, "sensor_msgs/CompressedImage")) {
    if (name.size() <= end.size() || name.substr(name.size() - end.size()) != end) continue;
    bases[name.substr(0, name.size() - end.size())].insert(kCompressed);
  }
  for (const std::string& name : previews) bases.erase(name);
  return bases;
}

}  // namespace

std::optional<ImageTopic> GuessImageTopic(const std::vector<PublishedTopic>& topics,
                                          const std::vector<std::string>& previews,
                                          const std::string& transport) {
  const auto bases = ImageBases(topics, previews);
  Names names;
  for (const auto& [base, transports] : bases) names.insert(base);
  const auto base = TheOnlyOne(names, "sensor_msgs/Image or CompressedImage", "image");
  if (!base) return std::nullopt;
  if (transport != kGuessTopic) return ImageTopic{*base, transport};
  return ImageTopic{*base, bases.at(*base).count(kCompressed) > 0 ? kCompressed : kRaw};
}

std::optional<std::string> GuessCameraInfoTopic(const std::vector<PublishedTopic>& topics,
                                                const std::string& image_base) {
  const std::string type = "sensor_msgs/CameraInfo";
  const Names names = NamesOfType(topics, type);
  const std::string beside = image_base.substr(0, image_base.rfind('/') + 1) + "camera_info";
  if (names.count(beside) > 0) return beside;
  return TheOnlyOne(names, type, "camera_info");
}

std::optional<std::string> GuessOdometryTopic(const std::vector<PublishedTopic>& topics) {
  const std::string type = "nav_msgs/Odometry";
  return TheOnlyOne(NamesOfType(topics, type), type, "odom");
}

}  // namespace rovio_sfm
