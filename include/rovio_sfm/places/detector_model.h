#pragma once

#include <string>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// How well a word is detected where it exists: z says it was seen, e that it is there (FAB-MAP's
// detector model). The model file carries it. Ranking wants less than is seen again
// (docs/places.md): a rate too high makes the words that a right place lacks cost more than those
// it shares earn.
struct DetectorOptions {
  double p_z_given_e = 0.25;
  double p_z_given_not_e = 0.0;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("p_z_given_e", p_z_given_e, 0.01, 0.99,
                    "p(z=1 | e=1) of a rare word: the chance to see it again where it was seen");
    table.AddNumber("p_z_given_not_e", p_z_given_not_e, 0.0, 0.2, "p(z=1 | e=0)");
    table.AddRule("p_z_given_not_e", p_z_given_not_e < p_z_given_e, "below p_z_given_e");
  }
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
