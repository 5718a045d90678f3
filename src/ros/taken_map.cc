#include "rovio_sfm/ros/taken_map.h"

#include <exception>
#include <optional>
#include <string>

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/status.h"

namespace rovio_sfm {
namespace {

std::optional<LevelMap> FindMapOf(const MapSnapshot& snapshot, uint32_t session) {
  if (session == 0) return FindLargestMap(snapshot);
  const SessionSnapshot* found = FindSession(snapshot, SessionId{session});
  return found == nullptr ? std::nullopt : FindLevelMap(snapshot, found->map);
}

}  // namespace

TakenMap TakeMap(const MappingEngine& engine, uint32_t session) {
  TakenMap taken{{}, engine.Picture(), {}, {}};
  const std::optional<LevelMap> map = FindMapOf(*taken.picture.snapshot, session);
  const auto gauge = map ? GaugeOf(taken.picture, map->id) : std::nullopt;
  if (!gauge) {
    taken.status = NotFound("map: session " + std::to_string(session) +
                            (session == 0 ? " stands for the largest map, but there is none"
                                          : " is not known, or its map has no posed frame"));
    return taken;
  }
  taken.gauge = *gauge;
  try {
    taken.model = engine.ModelOf(*map);
    taken.status = Ok("map " + std::to_string(map->id.value));
  } catch (const std::exception& error) {  // a store that cannot be read
    taken.status = Internal(error.what());
  }
  return taken;
}

}  // namespace rovio_sfm
