#include "rovio_sfm/ros/node_parameters.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(NodeParameters, BecomeYaml) {
  XmlRpc::XmlRpcValue value;
  value["a"]["b"] = 3;
  value["a"]["c"] = 0.1;
  value["d"] = std::string("text");
  value["e"][0] = true;
  const YAML::Node node = ToYaml(value);
  EXPECT_EQ(node["a"]["b"].as<int>(), 3);
  EXPECT_EQ(node["a"]["c"].as<double>(), 0.1);
  EXPECT_EQ(node["d"].as<std::string>(), "text");
  EXPECT_TRUE(node["e"][0].as<bool>());
}

}  // namespace
}  // namespace rovio_sfm
