#include "rovio_sfm/mapping/start_session.h"

#include "rovio_sfm/mapping/adjust_session.h"
#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/stage_options.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {

bool StartSession(const BootstrapPair& pair, const std::deque<FrameEvent>& held,
                  const MapperOptions& options, Session* session) {
  const FrameEvent& first = held[pair.first];
  const FrameEvent& second = held[pair.second];
  session->AddKeyframe(first.id.index, MakeKeyframe(first, Rigid3{}, options));
  session->AddKeyframe(second.id.index, MakeKeyframe(second, pair.second_from_first, options));
  const LandmarkLimits triangulate = TriangulationLimits(options);
  TriangulateTracks(second.id.index, triangulate, session);
  if (!session->landmarks().empty()) AdjustLocally(second.id.index, options, session);
  if (session->landmarks().size() >= static_cast<size_t>(options.bootstrap.min_inliers) / 2) {
    return true;
  }
  session->RemoveKeyframe(second.id.index);
  session->RemoveKeyframe(first.id.index);
  return false;
}

}  // namespace rovio_sfm
