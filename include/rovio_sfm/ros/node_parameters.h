#pragma once

#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

namespace rovio_sfm {

// The parameters of a node as YAML, so that both go through one reader.
YAML::Node ToYaml(XmlRpc::XmlRpcValue value);

}  // namespace rovio_sfm
