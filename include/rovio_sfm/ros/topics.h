#pragma once

#include <cstdint>

// The names of all topics and services, with queue sizes and latching: every edge of the graph that
// ROS carries. Names are relative: a robot's nodes live in its namespace, mapping in its own.
namespace rovio_sfm::topics {

// A robot's sensors, from rovio_driver. Images queue up at the receiver's worker, not here.
inline constexpr char kImageRaw[] = "image_raw";                    // sensor_msgs/Image
inline constexpr char kImageCompressed[] = "image_raw/compressed";  // sensor_msgs/CompressedImage
inline constexpr char kCameraInfo[] = "camera_info";                // sensor_msgs/CameraInfo
inline constexpr char kOdom[] = "odom";                             // nav_msgs/Odometry
inline constexpr char kCmdVel[] = "cmd_vel";                        // geometry_msgs/Twist
inline constexpr char kStatus[] = "status";                         // RovioStatus
inline constexpr char kSetHead[] = "set_head";                      // service SetHead
inline constexpr char kSetCamera[] = "set_camera";                  // service SetCamera
inline constexpr char kDock[] = "dock";                             // service Dock
inline constexpr char kDiagnostics[] = "/diagnostics";
inline constexpr uint32_t kImageQueue = 2;
inline constexpr uint32_t kCameraInfoQueue = 2;
inline constexpr uint32_t kOdomQueue = 50;
inline constexpr uint32_t kTfQueue = 1000;
inline constexpr uint32_t kCmdVelQueue = 1;
inline constexpr uint32_t kStatusQueue = 1;  // latched

// A frontend's results, in its robot's namespace. Frame events are never dropped on purpose: the
// queue holds minutes.
inline constexpr char kFrames[] = "frames";               // FrameEventMsg
inline constexpr char kPreview[] = "image";               // sensor_msgs/Image, decoded
inline constexpr char kDebugMatches[] = "debug/matches";  // sensor_msgs/Image, the filters drawn
inline constexpr char kGetFrames[] = "get_frames";        // service GetFrames
inline constexpr char kThresholds[] = "thresholds";  // private: dynamic_reconfigure's parameters
inline constexpr uint32_t kFramesQueue = 1000;
inline constexpr uint32_t kPreviewQueue = 1;

// The map, in mapping's namespace.
inline constexpr char kCloud[] = "cloud";               // sensor_msgs/PointCloud2, latched
inline constexpr char kCloudPrefix[] = "cloud/map_";    // the same, one a map but the root
inline constexpr char kPathPrefix[] = "path/session_";  // nav_msgs/Path, latched, one a session
inline constexpr char kCameras[] = "cameras";  // visualization_msgs/MarkerArray: all, then changes
inline constexpr char kPaths[] = "paths";      // visualization_msgs/MarkerArray, likewise
inline constexpr char kMapsApart[] = "maps_apart";    // visualization_msgs/MarkerArray, latched
inline constexpr char kDenseCloud[] = "dense_cloud";  // sensor_msgs/PointCloud2, latched
inline constexpr char kDenseCloudPrefix[] = "dense_cloud/map_";  // the same, one a map but the root
inline constexpr char kMesh[] = "mesh";             // visualization_msgs/Marker, latched
inline constexpr char kMeshPrefix[] = "mesh/map_";  // the same, one a map but the root
inline constexpr char kGrid[] = "grid";  // nav_msgs/OccupancyGrid, latched, of the root map
inline constexpr char kKeyframePose[] = "keyframe_pose";              // geometry_msgs/PoseStamped
inline constexpr char kPose[] = "pose";                               // geometry_msgs/PoseStamped
inline constexpr char kMapStatus[] = "map_status";                    // MapStatus, latched
inline constexpr char kListSessions[] = "list_sessions";              // service ListSessions
inline constexpr char kMergeSessions[] = "merge_sessions";            // service MergeSessions
inline constexpr char kUnmergeSession[] = "unmerge_session";          // service UnmergeSession
inline constexpr char kStartSession[] = "start_session";              // service StartSession
inline constexpr char kFinishSession[] = "finish_session";            // service FinishSession
inline constexpr char kExportMap[] = "export_map";                    // service ExportMap
inline constexpr char kDensify[] = "densify";                         // action Densify
inline constexpr char kReconstructSurface[] = "reconstruct_surface";  // action ReconstructSurface
inline constexpr char kSaveMap[] = "save_map";                        // service SaveMap
inline constexpr char kLoadMap[] = "load_map";                        // service LoadMap
inline constexpr char kReset[] = "reset";                             // service Reset
inline constexpr uint32_t kMapQueue = 1;
inline constexpr uint32_t kMarkersQueue = 100;  // changes: one forgotten would be missed
inline constexpr uint32_t kPoseQueue = 50;

// Place recognition, in its own namespace: that of mapping.
inline constexpr char kPlaceMatches[] = "place_matches";  // PlaceMatchMsg
inline constexpr char kPlaceStatus[] = "place_status";    // PlaceStatus, latched
inline constexpr char kFindOverlaps[] = "find_overlaps";  // service FindOverlaps
inline constexpr char kQueryImage[] = "query_image";      // service QueryImage
inline constexpr uint32_t kPlaceMatchesQueue = 1000;      // none is dropped on purpose
inline constexpr uint32_t kPlaceStatusQueue = 1;

}  // namespace rovio_sfm::topics
