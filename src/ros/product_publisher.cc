#include "rovio_sfm/ros/product_publisher.h"

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/product_messages.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr bool kLatched = true;
constexpr CloudPlace kRootPlace = {true, {}};

std::string TopicOf(const CloudPlace& place, const char* root, const char* prefix) {
  return place.is_root ? root : prefix + std::to_string(place.map.value);
}

// Where, and in which frame, a map is shown.
struct Placed {
  std::string frame;
  MapProducts products;
};

std::map<CloudPlace, Placed> Place(const MapPicture& picture,
                                   const std::map<MapId, MapProducts>& products) {
  const SessionSnapshot* root = FindRoot(*picture.snapshot);
  std::map<CloudPlace, Placed> placed;
  for (const auto& [id, of_map] : products) {
    const auto map = FindLevelMap(*picture.snapshot, id);
    if (!map) continue;
    const bool is_root = root != nullptr && root->map == id;
    placed[{is_root, id}] = {is_root ? MapFrame() : SessionFrame(map->sessions.front().id), of_map};
  }
  return placed;
}

}  // namespace

ProductPublisher::ProductPublisher(ros::NodeHandle node)
    : node_(node),
      grid_(node.advertise<nav_msgs::OccupancyGrid>(topics::kGrid, topics::kMapQueue, kLatched)) {
  OutputOf(kRootPlace).frame = MapFrame();
}

ProductPublisher::Output& ProductPublisher::OutputOf(const CloudPlace& place) {
  Output& output = outputs_[place];
  if (!output.cloud) {
    output.cloud = node_.advertise<sensor_msgs::PointCloud2>(
        TopicOf(place, topics::kDenseCloud, topics::kDenseCloudPrefix), topics::kMapQueue,
        kLatched);
    output.mesh = node_.advertise<visualization_msgs::Marker>(
        TopicOf(place, topics::kMesh, topics::kMeshPrefix), topics::kMapQueue, kLatched);
  }
  return output;
}

void ProductPublisher::Publish(const MapPicture& picture,
                               const std::map<MapId, MapProducts>& products) {
  auto placed = Place(picture, products);
  for (auto& [place, output] : outputs_) {
    if (placed.count(place) == 0) placed[place].frame = output.frame;
  }
  for (const auto& [place, now] : placed) {
    Output& output = OutputOf(place);
    Send(now.frame, now.products, &output);
    if (place.is_root && output.shown.grid != now.products.grid) {
      const auto& grid = now.products.grid;
      grid_.publish(GridMessage(grid ? *grid : OccupancyGridMap(), now.frame, ros::Time::now()));
    }
    output.frame = now.frame;
    output.shown = now.products;
  }
}

void ProductPublisher::Send(const std::string& frame, const MapProducts& products, Output* output) {
  const ros::Time stamp = ros::Time::now();
  if (const auto& cloud = products.NewestCloud(); output->shown.NewestCloud() != cloud) {
    output->cloud.publish(DenseCloudMessage(cloud ? *cloud : PointCloud(), frame, stamp));
  }
  if (output->shown.surface != products.surface) {
    output->mesh.publish(
        MeshMarker(products.surface ? *products.surface : TriangleMesh(), frame, stamp));
  }
}

}  // namespace rovio_sfm
