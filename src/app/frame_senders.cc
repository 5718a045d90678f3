#include "rovio_sfm/app/frame_senders.h"

namespace rovio_sfm {

std::optional<std::string> FrameSenders::RefusalOf(const DriveId& drive,
                                                   const FrameOrigin& origin) {
  Owner& owner =
      owners_.try_emplace(drive.robot, Owner{drive, origin.sender, origin.arrived_s}).first->second;
  const bool is_owner = owner.sender == origin.sender;
  if (!is_owner && owner.drive == drive) return std::nullopt;  // the same, by another way
  const bool is_heard = origin.arrived_s - owner.heard_s <= kSilenceS;
  if (!is_owner && is_heard && !origin.is_only_sender) {
    ++num_refused_;
    return "robot " + drive.robot + ": " + origin.sender + " sends drive " + drive.ToString() +
           " while " + owner.sender + " sends " + owner.drive.ToString() +
           "; do two frontends share the name?";
  }
  owner = {drive, origin.sender, origin.arrived_s};
  return std::nullopt;
}

}  // namespace rovio_sfm
