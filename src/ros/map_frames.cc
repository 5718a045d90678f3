#include "rovio_sfm/ros/map_frames.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <regex>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/conversions.h"

namespace rovio_sfm {
namespace {

geometry_msgs::TransformStamped Edge(const std::string& parent, const std::string& child,
                                     const Rigid3& parent_from_child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped edge;
  edge.header.stamp = stamp;
  edge.header.frame_id = parent;
  edge.child_frame_id = child;
  edge.transform = ToTransform(parent_from_child);
  return edge;
}

constexpr uint32_t kMaxIndicesWithoutOdometry = 10;

// The robot's newest frame; one shortly before where only that tells of its wheels: a few frames
// without odometry do not part them from a metric map.
const OdometryAnchor& AnchorOf(const MapPicture& picture, const std::string& robot,
                               const SessionSnapshot& session) {
  const OdometryAnchor& newest = picture.anchors.at(robot);
  const auto wheels = picture.wheel_anchors.find(robot);
  if (!session.scale || wheels == picture.wheel_anchors.end()) return newest;
  const OdometryAnchor& before = wheels->second;
  const bool is_shortly_before = before.drive == newest.drive && before.session == newest.session &&
                                 newest.index - before.index <= kMaxIndicesWithoutOdometry;
  return is_shortly_before ? before : newest;
}

// The edge that carries a robot; nothing while its anchor has no pose.
std::optional<geometry_msgs::TransformStamped> RobotEdge(const std::string& robot,
                                                         const OdometryAnchor& anchor,
                                                         const SessionSnapshot& session,
                                                         const ros::Time& stamp) {
  const FrameSnapshot* frame = FindAnchorFrame(session, anchor);
  if (frame == nullptr) return std::nullopt;
  const std::optional<Rigid3> level_from_camera = CameraInLevel(session, *frame);
  if (!level_from_camera) return std::nullopt;
  const std::string parent = SessionFrame(session.id);
  if (!session.scale || !anchor.odometry || !frame->base_from_camera) {
    return Edge(parent, robot + "/camera_map", *level_from_camera, stamp);
  }
  const Rigid3 level_from_base = *level_from_camera * Inverse(*frame->base_from_camera);
  const Rigid3 level_from_odom = level_from_base * Inverse(OdomFromBase(*anchor.odometry));
  return Edge(parent, robot + "/odom", level_from_odom, stamp);
}

// map_from_level of a session of the root map; equal scales, so a rigid motion is left.
std::optional<Rigid3> RootFromLevel(const SessionSnapshot& root, const SessionSnapshot& session) {
  const std::optional<Sim3> root_level = LevelInUnitOfMap(root);
  const std::optional<Sim3> level = LevelInUnitOfMap(session);
  if (!root_level || !level) return std::nullopt;
  const Sim3 root_from_level =
      *root_level * Inverse(root.map_from_session) * session.map_from_session * Inverse(*level);
  return Rigid3{root_from_level.rotation, root_from_level.translation};
}

}  // namespace

std::string MapFrame() { return "map"; }

std::string SessionFrame(SessionId session) {
  return "session_" + std::to_string(session.value) + "/map";
}

bool IsMapEdge(const geometry_msgs::TransformStamped& edge) {
  static const std::regex session_frame("/?session_[0-9]+/map");
  return std::regex_match(edge.header.frame_id, session_frame) ||
         std::regex_match(edge.child_frame_id, session_frame);
}

tf2_msgs::TFMessage WithoutMapEdges(const tf2_msgs::TFMessage& message) {
  tf2_msgs::TFMessage inputs;
  std::copy_if(message.transforms.begin(), message.transforms.end(),
               std::back_inserter(inputs.transforms),
               [](const geometry_msgs::TransformStamped& edge) { return !IsMapEdge(edge); });
  return inputs;
}

std::vector<geometry_msgs::TransformStamped> MapEdges(const MapPicture& picture,
                                                      const ros::Time& stamp) {
  std::vector<geometry_msgs::TransformStamped> edges;
  const SessionSnapshot* root = FindRoot(*picture.snapshot);
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    if (root == nullptr || !(session.map == root->map)) continue;
    const auto root_from_level = RootFromLevel(*root, session);
    if (root_from_level) {
      edges.push_back(Edge(MapFrame(), SessionFrame(session.id), *root_from_level, stamp));
    }
  }
  for (const auto& [robot, anchor] : picture.anchors) {
    const SessionSnapshot* session = FindSession(*picture.snapshot, anchor.session);
    if (session == nullptr) continue;
    const OdometryAnchor& place = AnchorOf(picture, robot, *session);
    if (const auto edge = RobotEdge(robot, place, *session, stamp)) edges.push_back(*edge);
  }
  return edges;
}

}  // namespace rovio_sfm
