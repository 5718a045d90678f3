#pragma once

#include <string>

namespace rovio_sfm {

// How well a word is detected where it exists: z says it was seen, e that it is there (FAB-MAP's
// detector model). train_places measures it and the model file carries it.
struct DetectorOptions {
  // p(z=1 | e=1) of a rare word: the chance to see it again where it was seen; 0.01 to 0.99.
  double p_z_given_e = 0.25;
  // p(z=1 | e=0): false detections; 0 to 0.2, below p_z_given_e.
  double p_z_given_not_e = 0.0;

  bool IsValid(std::string* error) const;
};

// The detector of one word, so that p_z = p_z_given_e * p_e + p_z_given_not_e * (1 - p_e).
struct WordDetector {
  double p_z_given_e = 0.0;
  double p_z_given_not_e = 0.0;
  double p_e = 0.0;  // prior that the word exists at a place, inside (0, 1)
};

// The detector of a word that is present in a share p_z of images, 0 < p_z < 1. A frequent word is
// also seen again by chance, p_z_given_e + (1 - p_z_given_e) p_z; false detections are at most half
// of p_z. So p_e follows from p_z without being cut.
WordDetector DetectorOfWord(const DetectorOptions& options, double p_z);

}  // namespace rovio_sfm
