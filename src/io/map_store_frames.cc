#include "rovio_sfm/io/map_store_frames.h"

#include <utility>

#include "rovio_sfm/io/map_store_codec.h"

namespace rovio_sfm {
namespace {

Camera ReadCamera(const Rows& rows, int column) {
  Camera camera;
  camera.width = static_cast<int>(rows.Int(column));
  camera.height = static_cast<int>(rows.Int(column + 1));
  double* const values[] = {&camera.fx, &camera.fy, &camera.cx, &camera.cy, &camera.k1,
                            &camera.k2, &camera.p1, &camera.p2, &camera.k3};
  for (int i = 0; i < 9; ++i) *values[i] = rows.Double(column + 2 + i);
  return camera;
}

void RequireCount(const char* column, size_t count, size_t expected) {
  if (count == expected) return;
  throw StoreError(std::string(column) + ": " + std::to_string(count) + " values, expected " +
                   std::to_string(expected) + ", as many as keypoints ask for");
}

void RequireFeatures(const std::vector<FeatureMatch>& inliers, size_t num_features) {
  for (const FeatureMatch& inlier : inliers) {
    if (inlier.b < num_features) continue;
    throw StoreError("inliers: feature = " + std::to_string(inlier.b) + ": expected less than " +
                     std::to_string(num_features));
  }
}

}  // namespace

StoredFrames::StoredFrames(StoreDatabase* database) : database_(database) {
  Rows rows = database_->Query(
      "SELECT id, robot, start_ns, nonce, width, height, fx, fy, cx, cy, k1, k2, p1, p2, k3 "
      "FROM drive ORDER BY id");
  while (rows.Next()) {
    const DriveId id{rows.Text(1), rows.Int(2), static_cast<uint32_t>(rows.Int(3))};
    const Camera camera = ReadCamera(rows, 4);
    std::string error;  // names of robots become names of files
    if (!IsValidRobotName(id.robot, &error) || !camera.IsValid(&error)) {
      throw StoreError(database_->file() + ": drive " + std::to_string(rows.Int(0)) + ": " + error);
    }
    drives_[rows.Int(0)] = {id, camera};
    rows_[id] = rows.Int(0);
  }
}

int64_t StoredFrames::RowOf(const DriveId& drive, const Camera& camera) {
  const auto known = rows_.find(drive);
  if (known != rows_.end()) return known->second;
  database_->Run(
      "INSERT INTO drive (robot, start_ns, nonce, width, height, fx, fy, cx, cy, k1, k2, p1, p2, "
      "k3) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      drive.robot, drive.start_ns, drive.nonce, camera.width, camera.height, camera.fx, camera.fy,
      camera.cx, camera.cy, camera.k1, camera.k2, camera.p1, camera.p2, camera.k3);
  const int64_t row = database_->LastId();
  drives_[row] = {drive, camera};
  rows_[drive] = row;
  return row;
}

std::optional<int64_t> StoredFrames::FindRow(const DriveId& drive) const {
  const auto known = rows_.find(drive);
  if (known == rows_.end()) return std::nullopt;
  return known->second;
}

DriveId StoredFrames::DriveAt(int64_t row) const {
  const auto drive = drives_.find(row);
  if (drive != drives_.end()) return drive->second.id;
  throw StoreError(database_->file() + ": drive " + std::to_string(row) + " is missing");
}

Camera StoredFrames::CameraAt(int64_t row) const {
  DriveAt(row);  // throws where there is none
  return drives_.at(row).camera;
}

std::optional<int64_t> StoredFrames::RowOfFrame(const FrameId& id) const {
  const std::optional<int64_t> drive = FindRow(id.drive);
  if (!drive) return std::nullopt;
  return FrameRow(*drive, id.index);
}

void StoredFrames::PutFrame(const FrameEvent& event, bool keep_image) {
  const int64_t drive = RowOf(event.id.drive, event.camera);
  const int64_t row = FrameRow(drive, event.id.index);
  Rows known = database_->Query("SELECT 1 FROM frame WHERE id = ?", row);
  if (known.Next()) return;
  std::optional<std::string> odometry, base_from_camera;
  if (event.odometry) odometry = OdometryBytes(*event.odometry);
  if (event.base_from_camera) base_from_camera = PoseBytes(*event.base_from_camera);
  const std::string tracks = TrackBytes(event.tracks);
  const std::string keypoints = KeypointBytes(*event.features);
  const auto blob = [](const std::optional<std::string>& bytes) {
    return bytes ? std::optional<Blob>(BlobOf(*bytes)) : std::nullopt;
  };
  database_->Run(
      "INSERT INTO frame (id, drive, number, is_light, stamp_ns, image_name, camera_frame, blur, "
      "odometry, base_from_camera, tracks, keypoints) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      row, drive, event.id.index, event.kind == FrameKind::kLight ? 1 : 0, event.stamp_ns,
      event.image_name, event.camera_frame, event.blur, blob(odometry), blob(base_from_camera),
      BlobOf(tracks), BlobOf(keypoints));
  const Descriptors& descriptors = event.features->descriptors;
  if (descriptors.length > 0) {
    database_->Run(
        "INSERT INTO descriptors (frame, type, metric, length, data) VALUES (?, ?, ?, ?, ?)", row,
        static_cast<int>(descriptors.type), static_cast<int>(descriptors.metric),
        descriptors.length, BlobOf(descriptors.data));
  }
  if (keep_image && event.jpeg != nullptr) {
    database_->Run("INSERT INTO image (frame, jpeg) VALUES (?, ?)", row, BlobOf(*event.jpeg));
  }
  PutPairs(row, event);
}

void StoredFrames::PutPairs(int64_t row, const FrameEvent& event) {
  int position = 0;
  for (const PairMatches& pair : event.pairs) {
    const MatchCounts& counts = pair.counts;
    const std::string pose = PoseBytes(pair.cam_from_other), inliers = InlierBytes(pair.inliers);
    database_->Run(
        "INSERT INTO pair (frame, position, other_number, num_features, num_ratio, num_percentile, "
        "num_one_to_one, num_ransac, num_guided, verdict, median_parallax_rad, pose, inliers) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        row, position++, pair.other_index, counts.features, counts.ratio, counts.percentile,
        counts.one_to_one, counts.ransac, counts.guided, static_cast<int>(pair.verdict),
        pair.median_parallax_rad, BlobOf(pose), BlobOf(inliers));
  }
  position = 0;
  for (const TrackLink& link : event.links) {
    database_->Run("INSERT INTO track_link (frame, position, a, b) VALUES (?, ?, ?, ?)", row,
                   position++, link.a, link.b);
  }
}

void StoredFrames::PutState(const DriveId& drive, const DriveState& state) {
  const std::optional<int64_t> row = FindRow(drive);
  if (!row) return;  // no frame of it came
  const std::string bytes = DriveStateBytes(state);
  database_->Run("UPDATE drive SET state = ? WHERE id = ?", BlobOf(bytes), *row);
}

std::vector<DriveRecord> StoredFrames::ReadDrives() const {
  std::vector<DriveRecord> records;
  Rows rows = database_->Query("SELECT id, state FROM drive ORDER BY id");
  while (rows.Next()) {
    const Drive& drive = drives_.at(rows.Int(0));
    records.push_back({drive.id, drive.camera, {}});
    if (!rows.IsNull(1)) records.back().state = ReadDriveState(rows.Bytes(1));
  }
  return records;
}

std::vector<uint32_t> StoredFrames::ReadIndices(const DriveId& drive, uint32_t first,
                                                uint32_t max_count) const {
  std::vector<uint32_t> indices;
  const std::optional<int64_t> row = FindRow(drive);
  if (!row) return indices;
  Rows rows = database_->Query(
      "SELECT number FROM frame WHERE drive = ? AND number >= ? ORDER BY number LIMIT ?", *row,
      first, max_count);
  while (rows.Next()) indices.push_back(static_cast<uint32_t>(rows.Int(0)));
  return indices;
}

std::optional<FrameEvent> StoredFrames::ReadEvent(const FrameId& id, EventParts parts) const {
  const std::optional<int64_t> row = RowOfFrame(id);
  if (!row) return std::nullopt;
  return WithFileNamed(database_->file(), [&] { return ReadRow(id, *row, parts); });
}

std::optional<FrameEvent> StoredFrames::ReadRow(const FrameId& id, int64_t row,
                                                EventParts parts) const {
  Rows rows = database_->Query(
      "SELECT is_light, stamp_ns, image_name, camera_frame, blur, odometry, base_from_camera, "
      "tracks, keypoints FROM frame WHERE id = ?",
      row);
  if (!rows.Next()) return std::nullopt;
  FrameEvent event;
  event.id = id;
  event.camera = drives_.at(*FindRow(id.drive)).camera;
  event.kind = rows.Int(0) == 1 ? FrameKind::kLight : FrameKind::kKeyframe;
  event.stamp_ns = rows.Int(1);
  event.image_name = rows.Text(2);
  event.camera_frame = rows.Text(3);
  event.blur = rows.Double(4);
  if (!rows.IsNull(5)) event.odometry = ReadOdometry(rows.Bytes(5));
  if (!rows.IsNull(6)) event.base_from_camera = ReadPose(rows.Bytes(6));
  event.tracks = ReadTracks(rows.Bytes(7));
  auto features = std::make_shared<FrameFeatures>(ReadKeypoints(rows.Bytes(8)));
  RequireCount("tracks", event.tracks.size(), features->keypoints.size());
  if (parts == EventParts::kAll) ReadDescriptors(row, features.get());
  event.features = std::move(features);
  if (parts == EventParts::kBare) return event;
  event.pairs = ReadPairs(row, event.tracks.size());
  event.links = ReadLinks(row);
  event.jpeg = ReadImage(id);
  return event;
}

void StoredFrames::ReadDescriptors(int64_t row, FrameFeatures* features) const {
  Rows rows =
      database_->Query("SELECT type, metric, length, data FROM descriptors WHERE frame = ?", row);
  if (!rows.Next()) return;
  Descriptors* const descriptors = &features->descriptors;
  descriptors->type = ReadEnum(rows, 0, DescriptorType::kSurf, "descriptors.type");
  descriptors->metric = ReadEnum(rows, 1, DescriptorMetric::kHamming, "descriptors.metric");
  descriptors->length = static_cast<uint32_t>(rows.Int(2));
  const Blob data = rows.Bytes(3);
  RequireCount("descriptors", data.size, features->keypoints.size() * descriptors->length);
  const auto* bytes = static_cast<const uint8_t*>(data.data);
  descriptors->data.assign(bytes, bytes + data.size);
}

std::shared_ptr<const FrameFeatures> StoredFrames::ReadFeatures(const FrameId& id) const {
  const std::optional<int64_t> row = RowOfFrame(id);
  if (!row) return nullptr;
  return WithFileNamed(database_->file(), [&] {
    std::shared_ptr<FrameFeatures> features;
    Rows rows = database_->Query("SELECT keypoints FROM frame WHERE id = ? AND is_light = 0", *row);
    if (rows.Next()) {
      features = std::make_shared<FrameFeatures>(ReadKeypoints(rows.Bytes(0)));
      ReadDescriptors(*row, features.get());
    }
    return std::shared_ptr<const FrameFeatures>(std::move(features));
  });
}

std::shared_ptr<const std::vector<uint8_t>> StoredFrames::ReadImage(const FrameId& id) const {
  const std::optional<int64_t> row = RowOfFrame(id);
  if (!row) return nullptr;
  Rows rows = database_->Query("SELECT jpeg FROM image WHERE frame = ?", *row);
  if (!rows.Next()) return nullptr;
  const Blob data = rows.Bytes(0);
  const auto* bytes = static_cast<const uint8_t*>(data.data);
  return std::make_shared<const std::vector<uint8_t>>(bytes, bytes + data.size);
}

std::vector<PairMatches> StoredFrames::ReadPairs(int64_t row, size_t num_features) const {
  std::vector<PairMatches> pairs;
  Rows rows = database_->Query(
      "SELECT other_number, num_features, num_ratio, num_percentile, num_one_to_one, num_ransac, "
      "num_guided, verdict, median_parallax_rad, pose, inliers FROM pair WHERE frame = ? "
      "ORDER BY position",
      row);
  while (rows.Next()) {
    PairMatches pair;
    pair.other_index = static_cast<uint32_t>(rows.Int(0));
    MatchCounts& counts = pair.counts;
    uint32_t* const values[] = {&counts.features,   &counts.ratio,  &counts.percentile,
                                &counts.one_to_one, &counts.ransac, &counts.guided};
    for (int i = 0; i < 6; ++i) *values[i] = static_cast<uint32_t>(rows.Int(1 + i));
    pair.verdict = ReadEnum(rows, 7, PairVerdict::kRotation, "pair.verdict");
    pair.median_parallax_rad = rows.Double(8);
    pair.cam_from_other = ReadPose(rows.Bytes(9));
    pair.inliers = ReadInliers(rows.Bytes(10));
    RequireFeatures(pair.inliers, num_features);
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::vector<TrackLink> StoredFrames::ReadLinks(int64_t row) const {
  std::vector<TrackLink> links;
  Rows rows =
      database_->Query("SELECT a, b FROM track_link WHERE frame = ? ORDER BY position", row);
  while (rows.Next()) {
    links.push_back({static_cast<TrackId>(rows.Int(0)), static_cast<TrackId>(rows.Int(1))});
  }
  return links;
}

}  // namespace rovio_sfm
