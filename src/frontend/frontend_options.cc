#include "rovio_sfm/frontend/frontend_options.h"

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {

bool MayFollow(const FrontendOptions& now, const FrontendOptions& next, std::string* error) {
  std::string complaint = FirstComplaint(next, "frontend");
  const auto keep = [&](const std::string& name, bool is_same) {
    if (is_same || !complaint.empty()) return;
    complaint = "frontend." + name + ": expected no change while the frontend runs";
  };
  keep("extract.type", next.extract.type == now.extract.type);
  keep("choose.mode", next.choose.mode == now.choose.mode);
  keep("light.enabled", next.light.enabled == now.light.enabled);
  keep("light.flow.window_px", next.light.flow.window_px == now.light.flow.window_px);
  keep("light.flow.levels", next.light.flow.levels == now.light.flow.levels);
  if (error != nullptr && !complaint.empty()) *error = complaint;
  return complaint.empty();
}

}  // namespace rovio_sfm
