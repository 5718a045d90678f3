#include "rovio_sfm/io/calibration.h"

#include <yaml-cpp/yaml.h>

#include <sstream>
#include <stdexcept>
#include <vector>

#include "rovio_sfm/geometry/check_calibration.h"
#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/util/load_document.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxYamlBytes = 64u << 10;

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error(path.string() + ": " + reason);
}

template <typename T>
T Value(const YAML::Node& node, const std::filesystem::path& path, const std::string& key) {
  const YAML::Node value = node[key];
  if (!value) Fail(path, "key " + key + ": missing");
  try {
    return value.as<T>();
  } catch (const YAML::Exception& error) {
    Fail(path, "key " + key + ": " + error.what());
  }
}

int Pixels(const YAML::Node& root, const std::filesystem::path& path, const std::string& key) {
  const auto text = Value<std::string>(root, path, key);
  if (IsDecimal(text)) return Value<int>(root, path, key);
  Fail(path, "key " + key + ": expected a whole number, not '" + text + "'");
}

std::vector<double> Matrix(const YAML::Node& root, const std::filesystem::path& path,
                           const std::string& key, size_t min_size, size_t max_size) {
  const YAML::Node matrix = Value<YAML::Node>(root, path, key);
  if (!matrix.IsMap()) Fail(path, "key " + key + ": expected rows, cols and data");
  const auto data = Value<std::vector<double>>(matrix, path, "data");
  if (data.size() < min_size || data.size() > max_size) {
    Fail(path, "key " + key + ": expected " + std::to_string(min_size) + " values, got " +
                   std::to_string(data.size()));
  }
  return data;
}

// k1 k2 p1 p2 k3. What a rational polynomial adds stands behind them.
std::vector<double> Distortion(const YAML::Node& root, const std::filesystem::path& path) {
  std::vector<double> d = Matrix(root, path, "distortion_coefficients", 4, 14);
  for (size_t i = 5; i < d.size(); ++i) {
    if (d[i] == 0.0) continue;
    Fail(path, "key distortion_coefficients: expected at most 5 values that are not zero");
  }
  d.resize(5, 0.0);
  return d;
}

Camera CameraFromYaml(const YAML::Node& root, const std::filesystem::path& path) {
  const auto model = Value<std::string>(root, path, "distortion_model");
  if (model != "plumb_bob" && model != "rational_polynomial") {
    Fail(path, "key distortion_model: expected plumb_bob, got " + model);
  }
  const std::vector<double> k = Matrix(root, path, "camera_matrix", 9, 9);
  const std::vector<double> d = Distortion(root, path);
  Camera camera;
  camera.fx = k[0], camera.cx = k[2], camera.fy = k[4], camera.cy = k[5];
  camera.k1 = d[0], camera.k2 = d[1], camera.p1 = d[2], camera.p2 = d[3], camera.k3 = d[4];
  camera.width = Pixels(root, path, "image_width");
  camera.height = Pixels(root, path, "image_height");
  return camera;
}

void EmitMatrix(YAML::Emitter* out, const std::string& key, int rows, int cols,
                const std::vector<double>& data) {
  *out << YAML::Key << key << YAML::Value << YAML::BeginMap;
  *out << YAML::Key << "rows" << YAML::Value << rows << YAML::Key << "cols" << YAML::Value << cols;
  *out << YAML::Key << "data" << YAML::Value << YAML::Flow << data << YAML::EndMap;
}

}  // namespace

Camera ReadCalibrationText(const std::filesystem::path& path) {
  const std::vector<TextLine> lines = ReadTextFile(path);
  if (lines.size() != 1) Fail(path, "expected one line of numbers");
  const TextLine& line = lines.front();
  line.RequireFields(11, "fx fy cx cy k1 k2 p1 p2 k3 width height");
  Camera camera;
  camera.fx = line.Number(0, "fx"), camera.fy = line.Number(1, "fy");
  camera.cx = line.Number(2, "cx"), camera.cy = line.Number(3, "cy");
  camera.k1 = line.Number(4, "k1"), camera.k2 = line.Number(5, "k2");
  camera.p1 = line.Number(6, "p1"), camera.p2 = line.Number(7, "p2");
  camera.k3 = line.Number(8, "k3");
  camera.width = line.PositiveInteger(9, "width");
  camera.height = line.PositiveInteger(10, "height");
  std::string error;
  if (!IsValidCalibration(camera, &error)) line.Fail(error);
  return camera;
}

Camera ReadCameraInfo(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = ReadBytes(path, kMaxYamlBytes);
  YAML::Node root;
  try {
    root = LoadDocument(std::string(bytes.begin(), bytes.end()));
  } catch (const YAML::Exception& error) {
    Fail(path, error.what());
  }
  if (!root.IsMap()) Fail(path, "expected a map of keys");
  const Camera camera = CameraFromYaml(root, path);
  std::string error;
  if (!IsValidCalibration(camera, &error)) Fail(path, error);
  return camera;
}

Camera ReadCamera(const std::filesystem::path& path) {
  const bool is_yaml = path.extension() == ".yaml" || path.extension() == ".yml";
  return is_yaml ? ReadCameraInfo(path) : ReadCalibrationText(path);
}

std::string CameraInfoYaml(const Camera& c, const std::string& camera_name) {
  YAML::Emitter out;
  out << YAML::BeginMap;
  out << YAML::Key << "image_width" << YAML::Value << c.width;
  out << YAML::Key << "image_height" << YAML::Value << c.height;
  out << YAML::Key << "camera_name" << YAML::Value << camera_name;
  EmitMatrix(&out, "camera_matrix", 3, 3, {c.fx, 0, c.cx, 0, c.fy, c.cy, 0, 0, 1});
  out << YAML::Key << "distortion_model" << YAML::Value << "plumb_bob";
  EmitMatrix(&out, "distortion_coefficients", 1, 5, {c.k1, c.k2, c.p1, c.p2, c.k3});
  EmitMatrix(&out, "rectification_matrix", 3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  EmitMatrix(&out, "projection_matrix", 3, 4, {c.fx, 0, c.cx, 0, 0, c.fy, c.cy, 0, 0, 0, 1, 0});
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

}  // namespace rovio_sfm
