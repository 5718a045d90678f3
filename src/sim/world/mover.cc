#include "rovio_sfm/sim/world/mover.h"

#include <cmath>

#include "rovio_sfm/sim/world/load_world.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {

bool MoverSpec::IsValid(std::string* error) const {
  OptionChecker check("mover", error);
  check.True("world", !world.empty() && world.find('/') == std::string::npos,
             "the name of a world");
  for (const double value : {from_m.x(), from_m.y(), to_m.x(), to_m.y()}) {
    check.Range("from_m, to_m", value, -1000.0, 1000.0);
  }
  check.Range("way from from_m to to_m, m", (to_m - from_m).norm(), 0.1, 1000.0);
  check.Range("speed_m_s", speed_m_s, 0.01, 10.0);
  return check.Passed();
}

Rigid3 PlaceOfMover(const MoverSpec& spec, double time_s) {
  const Eigen::Vector2d way = spec.to_m - spec.from_m;
  const double length_m = way.norm();
  const double gone_m = std::fmod(spec.speed_m_s * time_s, 2.0 * length_m);
  const bool returns = gone_m > length_m;
  const double share = (returns ? 2.0 * length_m - gone_m : gone_m) / length_m;
  const Eigen::Vector2d at = spec.from_m + share * way;
  const double yaw = std::atan2(way.y(), way.x()) + (returns ? M_PI : 0.0);
  return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())),
          {at.x(), at.y(), 0.0}};
}

Movers::Movers(const std::vector<MoverSpec>& specs, const std::string& worlds_folder)
    : specs_(specs) {
  for (const MoverSpec& spec : specs) {
    const std::string file = worlds_folder + "/" + spec.world + ".yaml";
    worlds_.push_back(std::make_shared<const World>(LoadWorld(file)));
  }
}

std::vector<PlacedWorld> Movers::At(double time_s) const {
  std::vector<PlacedWorld> placed;
  for (size_t i = 0; i < specs_.size(); ++i) {
    placed.push_back({worlds_[i].get(), PlaceOfMover(specs_[i], time_s)});
  }
  return placed;
}

}  // namespace rovio_sfm::sim
