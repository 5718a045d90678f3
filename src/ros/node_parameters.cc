#include "rovio_sfm/ros/node_parameters.h"

namespace rovio_sfm {
namespace {

YAML::Node ArrayToYaml(XmlRpc::XmlRpcValue* value) {
  YAML::Node node(YAML::NodeType::Sequence);
  for (int i = 0; i < value->size(); ++i) node.push_back(ToYaml((*value)[i]));
  return node;
}

YAML::Node StructToYaml(XmlRpc::XmlRpcValue* value) {
  YAML::Node node(YAML::NodeType::Map);
  for (auto& [name, child] : *value) node[name] = ToYaml(child);
  return node;
}

}  // namespace

YAML::Node ToYaml(XmlRpc::XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(value));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return YAML::Node(static_cast<double>(value));
    case XmlRpc::XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(value));
    case XmlRpc::XmlRpcValue::TypeArray:
      return ArrayToYaml(&value);
    case XmlRpc::XmlRpcValue::TypeStruct:
      return StructToYaml(&value);
    default:
      return YAML::Node();
  }
}

}  // namespace rovio_sfm
