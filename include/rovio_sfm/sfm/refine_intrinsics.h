#pragma once

#include "rovio_sfm/sfm/adjust_bundle.h"

namespace rovio_sfm {

// Solves a problem that is at its optimum once more with the corrections of its intrinsics. False,
// and nothing changes, where the pictures do not tell them: where they take less of the cost away
// than features that err alike along a track may by chance, where one lies farther off than its
// sigma lets expect, or where the earlier and the later half of the cameras tell different ones.
// Then something else bends the rays: a lens that its distortion does not describe, a rolling
// shutter. Without intrinsics: false.
bool RefineIntrinsics(const BundleOptions& options, BundleProblem* problem);

}  // namespace rovio_sfm
