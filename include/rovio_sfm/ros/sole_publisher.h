#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

namespace rovio_sfm {

// Throws std::runtime_error that names topic and node if a living node other than this one
// publishes one of the topics, which are resolved against the handle. A topic that this node
// publishes too is another's only if that one came first: of two that start at once one stays.
void RequireSolePublisher(const ros::NodeHandle& handle, const std::vector<std::string>& topics);

}  // namespace rovio_sfm
