#include "rovio_sfm/report/collect_model.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/report/name_pictures.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

using LandmarkId = std::pair<SessionId, TrackId>;

// A keyframe before its place in the list of images is known.
struct CollectedImage {
  ModelImage image;
  SessionId session;
  std::string image_name;
};

const Session& SessionOf(const SessionTable& sessions, SessionId id) {
  const Session* session = sessions.Find(id);
  ROVIO_CHECK(session != nullptr, "the map is not of these sessions");
  return *session;
}

// As the session's camera normalises them.
std::vector<Keypoint> KeypointsOf(const FrameId& id, const Keyframe& frame,
                                  const FrameStore& store) {
  const std::shared_ptr<const FrameFeatures> features = store.Get(id);
  if (features == nullptr || features->keypoints.size() != frame.points.size()) {
    throw std::runtime_error("the features of frame " + id.ToString() + " are not in the store");
  }
  std::vector<Keypoint> keypoints = features->keypoints;
  for (size_t i = 0; i < keypoints.size(); ++i) keypoints[i].x_normalized = frame.points[i];
  return keypoints;
}

class ModelCollector {
 public:
  ModelCollector(const LevelMap& map, const SessionTable& sessions, const FrameStore& store)
      : map_(map), sessions_(sessions) {
    model_.length_unit = map.scale ? "metres" : "map units";
    std::vector<CollectedImage> images;
    for (const SessionSnapshot& session : map.sessions) AddImages(session, store, &images);
    PlaceImages(std::move(images));
    AddPoints();
    for (const SessionSnapshot& session : map.sessions) AddViews(session);
    RemovePointsWithoutViews();
  }

  MapModel Take() { return std::move(model_); }

 private:
  void AddImages(const SessionSnapshot& snapshot, const FrameStore& store,
                 std::vector<CollectedImage>* images) {
    const Session& session = SessionOf(sessions_, snapshot.id);
    const uint32_t camera = CameraOf(session);
    const Sim3 level_from_session = map_.level_from_map * snapshot.map_from_session;
    for (const auto& [index, frame] : session.keyframes()) {
      if (frame.weak) continue;
      const FrameId id{session.drive(), index};
      images->push_back({{id, frame.stamp_ns, "", camera,
                          TransformCamera(level_from_session, frame.cam_from_session),
                          KeypointsOf(id, frame, store)},
                         snapshot.id,
                         frame.image_name});
    }
  }

  // Sessions of one drive share a camera as long as it has one calibration.
  uint32_t CameraOf(const Session& session) {
    std::vector<uint32_t>& of_drive = cameras_of_[session.drive()];
    for (const uint32_t camera : of_drive) {
      if (model_.cameras[camera] == session.camera()) return camera;
    }
    of_drive.push_back(static_cast<uint32_t>(model_.cameras.size()));
    model_.cameras.push_back(session.camera());
    return of_drive.back();
  }

  void PlaceImages(std::vector<CollectedImage> images) {
    std::sort(images.begin(), images.end(), [](const CollectedImage& a, const CollectedImage& b) {
      return a.image.id < b.image.id;
    });
    std::vector<std::string> image_names;
    for (CollectedImage& collected : images) {
      image_of_[{collected.session, collected.image.id.index}] =
          static_cast<uint32_t>(model_.images.size());
      image_names.push_back(collected.image_name);
      model_.images.push_back(std::move(collected.image));
    }
    NamePictures(image_names, &model_);
  }

  void AddPoints() {
    std::map<SessionId, Sim3> level_from_sessions;
    for (const SessionSnapshot& session : map_.sessions) {
      level_from_sessions[session.id] = map_.level_from_map * session.map_from_session;
    }
    for (const auto& [session, landmark] : UniteLandmarks(map_)) {
      if (!IsCounted(landmark)) continue;
      const size_t point = model_.points.size();
      point_of_[{session->id, landmark.id}] = point;
      if (const auto shared = SharedNumber({session->id, landmark.id})) shared_of_[*shared] = point;
      model_.points.push_back({level_from_sessions.at(session->id) * landmark.position,
                               landmark.color,
                               landmark.mean_error_px,
                               {}});
    }
  }

  std::optional<uint32_t> SharedNumber(const LandmarkId& id) const {
    if (map_.shared_landmarks == nullptr) return std::nullopt;
    const auto it = map_.shared_landmarks->find(id);
    return it == map_.shared_landmarks->end() ? std::nullopt : std::optional<uint32_t>(it->second);
  }

  std::optional<size_t> PointOf(const LandmarkId& id) const {
    if (const auto shared = SharedNumber(id)) {
      const auto it = shared_of_.find(*shared);
      return it == shared_of_.end() ? std::nullopt : std::optional<size_t>(it->second);
    }
    const auto it = point_of_.find(id);
    return it == point_of_.end() ? std::nullopt : std::optional<size_t>(it->second);
  }

  void AddViews(const SessionSnapshot& snapshot) {
    for (const auto& [id, landmark] : SessionOf(sessions_, snapshot.id).landmarks()) {
      const std::optional<size_t> point = PointOf({snapshot.id, id});
      if (!point) continue;
      std::vector<ModelView>& views = model_.points[*point].views;
      for (const Observation& observation : landmark.observations) {
        const auto image = image_of_.find({snapshot.id, observation.frame});
        if (image != image_of_.end()) views.push_back({image->second, observation.feature});
      }
    }
  }

  // A point whose landmarks two links have joined may have two features in one image since: the
  // first stays.
  void RemovePointsWithoutViews() {
    for (ModelPoint& point : model_.points) {
      const auto is_before = [](const ModelView& a, const ModelView& b) {
        return a.image < b.image;
      };
      const auto are_one = [](const ModelView& a, const ModelView& b) {
        return a.image == b.image;
      };
      std::stable_sort(point.views.begin(), point.views.end(), is_before);
      point.views.erase(std::unique(point.views.begin(), point.views.end(), are_one),
                        point.views.end());
    }
    model_.points.erase(
        std::remove_if(model_.points.begin(), model_.points.end(),
                       [](const ModelPoint& point) { return point.views.size() < 2; }),
        model_.points.end());
  }

  const LevelMap& map_;
  const SessionTable& sessions_;
  MapModel model_;
  std::map<DriveId, std::vector<uint32_t>> cameras_of_;
  std::map<std::pair<SessionId, uint32_t>, uint32_t> image_of_;
  std::map<LandmarkId, size_t> point_of_;
  std::map<uint32_t, size_t> shared_of_;  // by the number of SharedLandmarks
};

}  // namespace

MapModel CollectModel(const LevelMap& map, const SessionTable& sessions, const FrameStore& store) {
  return ModelCollector(map, sessions, store).Take();
}

}  // namespace rovio_sfm
