"""The acceptance of the second stage: places, and any number of drives in one map."""

from acceptance import merging, recognising
from acceptance.common import Line
from acceptance.stage_1 import demo

LINES = [
    Line("engine_room", "engineRoom0 + engineRoom1, noise 10: merged, joint error <= 1.5 % of the path",
         merging.all_overlaps, True),
    Line("one_overlap", "the same with one overlap (Table 5.8)", merging.one_overlap, True),
    Line("scale_ratio", "scale of drive 1 over that of drive 2's last 20 pictures within 3 % of one, pose "
         "graph on and off", merging.scale_ratio, False),
    Line("glance", "one picture of the second drive sees the place: merged, joint error <= 1.5 %",
         merging.glance, False),
    Line("laps", "turntable2: loop closed, the laps on each other within 1 cm", merging.laps, False),
    Line("places_turntable2", "turntable2, second lap, strict: recall at 100 / 95 % precision >= 0.90 / 0.95, area "
         ">= 0.95 and tf-idf's; after geometry precision >= 0.98 at recall >= 0.95", recognising.turntable2, False),
    Line("places_udes", "rtabmap_udes_2loops, a corridor twice, strict: the same, but recall >= 0.90 after geometry",
         recognising.udes, False),
    Line("places_fr1", "tum_fr1_rpy in tum_fr1_xyz, strict: as turntable2; two other training seeds: area >= "
         "tf-idf's", recognising.fr1, False),
    Line("halves", "tum_fr1_xyz in two halves: merged, joint error <= 2.0 cm", merging.halves, True),
    Line("xyz_and_rpy", "tum_fr1_xyz + tum_fr1_rpy: one map with >= 80 % of the second's pictures, <= 4 cm",
         merging.xyz_and_rpy, False),
    Line("four_drives", "three drives that overlap and one that does not, in 24 orders: three merged, the "
         "fourth alone", merging.four_drives, True),
    Line("adversarial", "adversarial evidence (i)-(iv): no wrong merge (unit tests)",
         merging.unit_tests("AdversarialMerge"), True),
    Line("twin_worlds", "two rooms with three identical objects in other arrangements: two maps",
         merging.twin_worlds, True),
    Line("castle", "leuven_castle beside everything: no wrong merge", merging.castle, False),
    Line("unmerge", "a forced wrong merge, 20 more pictures, undone: bytes of before (unit tests)",
         merging.unit_tests("MapperMerge"), True),
    Line("places_scale", "a query <= 20 ms at 1 000 places, <= 22 at 10 000, <= 40 at 100 000, <= 1.5 kB a "
         "place", recognising.scale, False),
    Line("node_restart", "the place node killed and restarted in the middle: one map (node tests)",
         recognising.node_tests, False),
    Line("lost", "robot lost in the middle (10 black pictures): one map again", merging.lost, False),
    Line("deterministic", "merged maps: the same bytes twice, with one and two threads",
         merging.deterministic, True),
    Line("live", "live: two robots merge in one map, by themselves and by rosservice",
         lambda quick: demo(quick, "--services"), False),
]
