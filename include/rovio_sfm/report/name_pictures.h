#pragma once

#include <vector>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// Names the pictures of a model <drive>/<file>, none twice: the file is image_names[i] without its
// folders where that is a plain name of a JPEG or PNG and the drive's only such, else
// frame_<index>.jpg. Image names come from messages: nothing of them leads out of the folder.
void NamePictures(const std::vector<std::string>& image_names, MapModel* model);

}  // namespace rovio_sfm
