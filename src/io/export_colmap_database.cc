#include "rovio_sfm/io/export_colmap_database.h"

#include <sqlite3.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/io/append_fields.h"
#include "rovio_sfm/io/colmap_camera.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMaxImages = 2147483647;  // of COLMAP's pair ids
constexpr int kCalibrated = 2;              // the kind of a two-view geometry with an essential one

// As `colmap database_creator` makes it.
constexpr char kSchema[] = R"(
PRAGMA user_version = 3800;
CREATE TABLE cameras (camera_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  model INTEGER NOT NULL, width INTEGER NOT NULL, height INTEGER NOT NULL, params BLOB,
  prior_focal_length INTEGER NOT NULL);
CREATE TABLE images (image_id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  name TEXT NOT NULL UNIQUE, camera_id INTEGER NOT NULL,
  prior_qw REAL, prior_qx REAL, prior_qy REAL, prior_qz REAL,
  prior_tx REAL, prior_ty REAL, prior_tz REAL,
  CONSTRAINT image_id_check CHECK(image_id >= 0 and image_id < 2147483647),
  FOREIGN KEY(camera_id) REFERENCES cameras(camera_id));
CREATE UNIQUE INDEX index_name ON images(name);
CREATE TABLE keypoints (image_id INTEGER PRIMARY KEY NOT NULL,
  rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB,
  FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);
CREATE TABLE descriptors (image_id INTEGER PRIMARY KEY NOT NULL,
  rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB,
  FOREIGN KEY(image_id) REFERENCES images(image_id) ON DELETE CASCADE);
CREATE TABLE matches (pair_id INTEGER PRIMARY KEY NOT NULL,
  rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB);
CREATE TABLE two_view_geometries (pair_id INTEGER PRIMARY KEY NOT NULL,
  rows INTEGER NOT NULL, cols INTEGER NOT NULL, data BLOB, config INTEGER NOT NULL,
  F BLOB, E BLOB, H BLOB, qvec BLOB, tvec BLOB);
BEGIN;
)";

// A database in memory.
class Database {
 public:
  Database() { Require(sqlite3_open(":memory:", &database_)); }
  ~Database() { sqlite3_close(database_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void Execute(const char* script) {
    Require(sqlite3_exec(database_, script, nullptr, nullptr, nullptr));
  }

  // One statement, its parameters bound in order.
  template <typename... Values>
  void Insert(const char* text, const Values&... values) {
    sqlite3_stmt* statement = nullptr;
    Require(sqlite3_prepare_v2(database_, text, -1, &statement, nullptr));
    int index = 0;
    const bool bound = ((Bind(statement, ++index, values) == SQLITE_OK) && ...);
    const bool done = bound && sqlite3_step(statement) == SQLITE_DONE;
    sqlite3_finalize(statement);
    if (!done) throw std::runtime_error(Message());
  }

  std::string Bytes() const {
    sqlite3_int64 size = 0;
    unsigned char* bytes = sqlite3_serialize(database_, "main", &size, 0);
    if (bytes == nullptr) throw std::runtime_error(Message());
    std::string copy(reinterpret_cast<const char*>(bytes), static_cast<size_t>(size));
    sqlite3_free(bytes);
    return copy;
  }

 private:
  static int Bind(sqlite3_stmt* statement, int index, int64_t value) {
    return sqlite3_bind_int64(statement, index, value);
  }
  static int Bind(sqlite3_stmt* statement, int index, const std::string& bytes) {
    return sqlite3_bind_blob64(statement, index, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
  }
  static int Bind(sqlite3_stmt* statement, int index, const char* text) {
    return sqlite3_bind_text(statement, index, text, -1, SQLITE_TRANSIENT);
  }
  std::string Message() const {
    return std::string("the database of COLMAP: ") + sqlite3_errmsg(database_);
  }
  void Require(int result) const {
    if (result != SQLITE_OK) throw std::runtime_error(Message());
  }

  sqlite3* database_ = nullptr;
};

void InsertCameras(const MapModel& model, Database* database) {
  for (size_t i = 0; i < model.cameras.size(); ++i) {
    const ColmapCamera camera = ToColmapCamera(model.cameras[i]);
    std::string parameters;
    for (const double parameter : camera.parameters) AppendBytes(parameter, &parameters);
    database->Insert("INSERT INTO cameras VALUES (?, ?, ?, ?, ?, 1)", static_cast<int64_t>(i + 1),
                     int64_t{camera.model_id}, int64_t{model.cameras[i].width},
                     int64_t{model.cameras[i].height}, parameters);
  }
}

// x y scale orientation; the scale is that of COLMAP's features, half the diameter.
std::string KeypointBytes(const std::vector<Keypoint>& keypoints) {
  std::string bytes;
  const auto centre = static_cast<float>(kColmapPixelCentre);
  for (const Keypoint& keypoint : keypoints) {
    AppendBytes(keypoint.x_px + centre, &bytes);
    AppendBytes(keypoint.y_px + centre, &bytes);
    AppendBytes(0.5f * keypoint.size_px, &bytes);
    AppendBytes(keypoint.angle_rad, &bytes);
  }
  return bytes;
}

void InsertImages(const MapModel& model, Database* database) {
  for (size_t i = 0; i < model.images.size(); ++i) {
    const ModelImage& image = model.images[i];
    const auto id = static_cast<int64_t>(i + 1);
    database->Insert("INSERT INTO images (image_id, name, camera_id) VALUES (?, ?, ?)", id,
                     image.name.c_str(), int64_t{image.camera} + 1);
    database->Insert("INSERT INTO keypoints VALUES (?, ?, 4, ?)", id,
                     static_cast<int64_t>(image.keypoints.size()), KeypointBytes(image.keypoints));
  }
}

// The features of two images that see the same points, one after the other, as bytes.
using MatchBytes = std::map<std::pair<uint32_t, uint32_t>, std::string>;

MatchBytes MatchesOfImages(const MapModel& model) {
  MatchBytes matches;
  for (const ModelPoint& point : model.points) {
    for (size_t i = 0; i < point.views.size(); ++i) {
      const size_t end = std::min(i + 1 + kMatchedViews, point.views.size());
      for (size_t j = i + 1; j < end; ++j) {
        std::string& bytes = matches[{point.views[i].image, point.views[j].image}];
        AppendBytes(point.views[i].keypoint, &bytes);
        AppendBytes(point.views[j].keypoint, &bytes);
      }
    }
  }
  return matches;
}

void InsertPair(const Rigid3& b_from_a, int64_t pair_id, const std::string& matches,
                Database* database) {
  const Eigen::Vector3d t = b_from_a.translation.normalized();
  const Eigen::Quaterniond& q = b_from_a.rotation;
  Eigen::Matrix3d cross;
  cross << 0.0, -t.z(), t.y(), t.z(), 0.0, -t.x(), -t.y(), t.x(), 0.0;
  const Eigen::Matrix3d essential = cross * q.toRotationMatrix();
  std::string essential_bytes, rotation_bytes, translation_bytes;
  for (int i = 0; i < 9; ++i) AppendBytes(essential(i / 3, i % 3), &essential_bytes);
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) AppendBytes(value, &rotation_bytes);
  for (int i = 0; i < 3; ++i) AppendBytes(t(i), &translation_bytes);
  database->Insert(
      "INSERT INTO two_view_geometries (pair_id, rows, cols, data, config, E, qvec, tvec) "
      "VALUES (?, ?, 2, ?, ?, ?, ?, ?)",
      pair_id, static_cast<int64_t>(matches.size() / 8), matches, int64_t{kCalibrated},
      essential_bytes, rotation_bytes, translation_bytes);
}

void InsertMatches(const MapModel& model, Database* database) {
  for (const auto& [pair, bytes] : MatchesOfImages(model)) {
    const Rigid3& a_from_map = model.images[pair.first].cam_from_map;
    const Rigid3& b_from_map = model.images[pair.second].cam_from_map;
    const int64_t pair_id = kMaxImages * (int64_t{pair.first} + 1) + int64_t{pair.second} + 1;
    InsertPair(b_from_map * Inverse(a_from_map), pair_id, bytes, database);
  }
}

}  // namespace

std::string ColmapDatabaseBytes(const MapModel& model) {
  Database database;
  database.Execute(kSchema);
  InsertCameras(model, &database);
  InsertImages(model, &database);
  InsertMatches(model, &database);
  database.Execute("COMMIT");
  return database.Bytes();
}

}  // namespace rovio_sfm
