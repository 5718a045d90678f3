"""The lines about places: the shipped model, its ranking judged strictly."""

from acceptance import recognising
from acceptance.common import NOISE, Line, dataset, render_tour


def fr1(_quick):
    distractors = [dataset("leuven_castle"), render_tour("engineRoom0", NOISE, 1), render_tour("visionlab", NOISE, 1)]
    return recognising.judge_strictly(
        recognising.evaluate("fr1_strict", [dataset("tum_fr1_rpy")], [dataset("tum_fr1_xyz")], distractors, "--truth", "poses",
                             "--stride", 5, "--prior", *recognising.model_options()), 0.95)


LINES = [
    Line("places_fr1", "places, tum_fr1_rpy in tum_fr1_xyz: strict recall >= 0.90 at 100 %, >= 0.95 at 95 % precision, area "
         ">= 0.95 and >= tf-idf's; after geometry precision >= 0.98, recall >= 0.95", fr1, False),
    Line("places_udes", "places, udes: the same, recall after geometry >= 0.90", recognising.udes, False),
    Line("places_turntable2", "places, turntable2's second lap: as fr1", recognising.turntable2, False),
]
