#include "rovio_sfm/io/map_store_schema.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kApplicationId = 0x726f7673;  // "rovs", of SQLite's header

constexpr const char* kTables = R"(
CREATE TABLE info (
  name TEXT PRIMARY KEY,
  value TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE drive (
  id INTEGER PRIMARY KEY,
  robot TEXT NOT NULL,
  start_ns INTEGER NOT NULL,
  nonce INTEGER NOT NULL,
  width INTEGER NOT NULL,
  height INTEGER NOT NULL,
  fx REAL NOT NULL, fy REAL NOT NULL, cx REAL NOT NULL, cy REAL NOT NULL,
  k1 REAL NOT NULL, k2 REAL NOT NULL, p1 REAL NOT NULL, p2 REAL NOT NULL, k3 REAL NOT NULL,
  state BLOB,
  UNIQUE (robot, start_ns, nonce)
) STRICT;

CREATE TABLE frame (
  id INTEGER PRIMARY KEY,
  drive INTEGER NOT NULL REFERENCES drive (id),
  number INTEGER NOT NULL,
  is_light INTEGER NOT NULL,
  stamp_ns INTEGER NOT NULL,
  image_name TEXT NOT NULL,
  camera_frame TEXT NOT NULL,
  blur REAL NOT NULL,
  odometry BLOB,
  base_from_camera BLOB,
  tracks BLOB NOT NULL,
  keypoints BLOB NOT NULL,
  UNIQUE (drive, number)
) STRICT;

CREATE TABLE descriptors (
  frame INTEGER PRIMARY KEY REFERENCES frame (id),
  type INTEGER NOT NULL,
  metric INTEGER NOT NULL,
  length INTEGER NOT NULL,
  data BLOB NOT NULL
) STRICT;

CREATE TABLE image (
  frame INTEGER PRIMARY KEY REFERENCES frame (id),
  jpeg BLOB NOT NULL
) STRICT;

CREATE TABLE pair (
  frame INTEGER NOT NULL REFERENCES frame (id),
  position INTEGER NOT NULL,
  other_number INTEGER NOT NULL,
  num_features INTEGER NOT NULL,
  num_ratio INTEGER NOT NULL,
  num_percentile INTEGER NOT NULL,
  num_one_to_one INTEGER NOT NULL,
  num_ransac INTEGER NOT NULL,
  num_guided INTEGER NOT NULL,
  verdict INTEGER NOT NULL,
  median_parallax_rad REAL NOT NULL,
  pose BLOB NOT NULL,
  inliers BLOB NOT NULL,
  PRIMARY KEY (frame, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE track_link (
  frame INTEGER NOT NULL REFERENCES frame (id),
  position INTEGER NOT NULL,
  a INTEGER NOT NULL,
  b INTEGER NOT NULL,
  PRIMARY KEY (frame, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE session (
  id INTEGER PRIMARY KEY,
  drive INTEGER NOT NULL REFERENCES drive (id),
  state INTEGER NOT NULL,
  metres_per_unit REAL,
  sigma_log_scale REAL,
  scale_source TEXT,
  odometry_delay_s REAL,
  odometry_delay_sigma_s REAL,
  num_marks INTEGER NOT NULL
) STRICT;

CREATE TABLE keyframe (
  session INTEGER NOT NULL REFERENCES session (id),
  frame INTEGER NOT NULL REFERENCES frame (id),
  is_weak INTEGER NOT NULL,
  pose BLOB NOT NULL,
  born INTEGER NOT NULL,
  moved INTEGER NOT NULL,
  PRIMARY KEY (session, frame)
) STRICT, WITHOUT ROWID;

CREATE TABLE keyframe_tracks (
  session INTEGER NOT NULL,
  frame INTEGER NOT NULL,
  tracks BLOB NOT NULL,
  PRIMARY KEY (session, frame),
  FOREIGN KEY (session, frame) REFERENCES keyframe (session, frame) ON DELETE CASCADE
) STRICT;

CREATE TABLE light_pose (
  session INTEGER NOT NULL REFERENCES session (id),
  frame INTEGER NOT NULL REFERENCES frame (id),
  reference INTEGER NOT NULL REFERENCES frame (id),
  pose BLOB NOT NULL,
  num_inliers INTEGER NOT NULL,
  born INTEGER NOT NULL,
  moved INTEGER NOT NULL,
  PRIMARY KEY (session, frame)
) STRICT, WITHOUT ROWID;

CREATE TABLE landmark_block (
  session INTEGER NOT NULL REFERENCES session (id),
  block INTEGER NOT NULL,
  landmarks BLOB NOT NULL,
  PRIMARY KEY (session, block)
) STRICT;

CREATE TABLE track_alias (
  session INTEGER NOT NULL REFERENCES session (id),
  track INTEGER NOT NULL,
  united_with INTEGER NOT NULL,
  PRIMARY KEY (session, track)
) STRICT, WITHOUT ROWID;

CREATE TABLE journal (
  id INTEGER PRIMARY KEY,
  session INTEGER NOT NULL REFERENCES session (id),
  mark INTEGER NOT NULL,
  metres_per_unit REAL,
  sigma_log_scale REAL,
  scale_source TEXT,
  entries BLOB NOT NULL
) STRICT;
CREATE INDEX journal_of_session ON journal (session, mark);

CREATE TABLE merge_edit (
  id INTEGER PRIMARY KEY,
  query_session INTEGER,
  other_session INTEGER,
  kind TEXT NOT NULL,
  verdict TEXT NOT NULL,
  reason TEXT NOT NULL,
  accepted_by INTEGER NOT NULL,
  sequence INTEGER NOT NULL,
  report BLOB NOT NULL,
  place_match BLOB NOT NULL,
  links BLOB NOT NULL,
  marks BLOB NOT NULL
) STRICT;

CREATE TABLE waiting_match (
  position INTEGER PRIMARY KEY,
  place_match BLOB NOT NULL
) STRICT;

CREATE TABLE gauge (
  map INTEGER PRIMARY KEY,
  revision INTEGER NOT NULL
) STRICT;

CREATE TABLE separated (
  a INTEGER NOT NULL REFERENCES session (id),
  b INTEGER NOT NULL REFERENCES session (id),
  PRIMARY KEY (a, b)
) STRICT, WITHOUT ROWID;
)";

// Since version 2.
constexpr const char* kCameraTable = R"(TABLE session_camera (
  session INTEGER NOT NULL,
  mark INTEGER NOT NULL,
  fx REAL NOT NULL, fy REAL NOT NULL, cx REAL NOT NULL, cy REAL NOT NULL,
  PRIMARY KEY (session, mark)
) STRICT, WITHOUT ROWID;
)";

int64_t ReadPragma(const char* text, StoreDatabase* database) {
  Rows rows = database->Query(text);
  return rows.Next() ? rows.Int(0) : 0;
}

bool IsEmpty(StoreDatabase* database) {
  Rows rows = database->Query("SELECT count(*) FROM sqlite_master");
  return rows.Next() && rows.Int(0) == 0;
}

void MakeTables(StoreDatabase* database) {
  database->Execute("BEGIN IMMEDIATE;" + std::string(kTables) + "CREATE " + kCameraTable +
                    "PRAGMA application_id = " + std::to_string(kApplicationId) +
                    "; PRAGMA user_version = " + std::to_string(kStoreVersion) + "; COMMIT;");
}

int64_t RequireVersion(StoreDatabase* database) {
  if (ReadPragma("PRAGMA application_id", database) != kApplicationId) {
    throw StoreError(database->file() + ": not a map store of rovio_sfm");
  }
  const int64_t version = ReadPragma("PRAGMA user_version", database);
  if (version == kStoreVersion || version == 1) return version;
  throw StoreError(database->file() + ": version = " + std::to_string(version) + ": expected " +
                   std::to_string(kStoreVersion) + ", which this program writes, or 1");
}

// A file that is only read stays of version 1: the new table is empty and beside it.
void MigrateFromOne(StoreAccess access, StoreDatabase* database) {
  if (access == StoreAccess::kRead) {
    database->Execute(std::string("CREATE TEMPORARY ") + kCameraTable);
  } else {
    database->Execute("BEGIN IMMEDIATE; CREATE " + std::string(kCameraTable) +
                      "PRAGMA user_version = 2; COMMIT;");
  }
}

}  // namespace

void OpenSchema(StoreAccess access, StoreDatabase* database) {
  database->Execute("PRAGMA foreign_keys = ON");
  const bool is_new = access == StoreAccess::kCreate && IsEmpty(database);
  // Before anything of another's file is changed.
  const int64_t version = is_new ? kStoreVersion : RequireVersion(database);
  if (access != StoreAccess::kRead) {
    database->Execute("PRAGMA synchronous = EXTRA; PRAGMA journal_mode = WAL");
  }
  if (is_new) MakeTables(database);
  if (version == 1) MigrateFromOne(access, database);
}

}  // namespace rovio_sfm
