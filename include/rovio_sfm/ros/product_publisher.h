#pragma once

#include <ros/ros.h>

#include <map>
#include <string>

#include "rovio_sfm/app/changed_parts.h"
#include "rovio_sfm/app/map_products.h"

namespace rovio_sfm {

// Sends what was made of maps, latched, when it is another than before: the root map's as
// dense_cloud, mesh and grid, in `map`; of every other map dense_cloud/map_<n> and mesh/map_<n>, in
// session_<n>/map. What holds no more is replaced by nothing. For one thread.
class ProductPublisher {
 public:
  explicit ProductPublisher(ros::NodeHandle node);

  void Publish(const MapPicture& picture, const std::map<MapId, MapProducts>& products);

 private:
  struct Output {
    ros::Publisher cloud, mesh;
    std::string frame;
    MapProducts shown;
  };

  Output& OutputOf(const CloudPlace& place);
  void Send(const std::string& frame, const MapProducts& products, Output* output);

  ros::NodeHandle node_;
  std::map<CloudPlace, Output> outputs_;
  ros::Publisher grid_;
};

}  // namespace rovio_sfm
