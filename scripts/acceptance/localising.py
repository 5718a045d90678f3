"""The lines about finding one's place in a map that stays what it is."""

import hashlib

import numpy

from acceptance import drives
from acceptance.common import NOISE, PLACES, ROOT, THREADS, WORK, Line, dataset, map_images, render_tour, run
from acceptance.recognising import FIRST_LAP
from acceptance.trajectories import pair_up, read_centers, transform, umeyama

TOLERANCE_NS = 20_000_000  # between a picture and the true pose beside it


def localise(name, mapped, asked, *options):
    """Maps one folder, then poses the pictures of another in it. Returns (errors of the poses, m,
    after the similarity of the map's own path; pictures asked; whether map.db stayed the same)."""
    map_images(name, [mapped], *options)
    out = WORK / name
    before = hashlib.sha256((out / "map.db").read_bytes()).digest()
    run(ROOT / "scripts/map_images", asked, "--out", out, "--threads", THREADS, "--localize", *PLACES)
    same = before == hashlib.sha256((out / "map.db").read_bytes()).digest()
    path = pair_up(read_centers(out / "trajectory.txt"), read_centers(mapped / "groundtruth.txt"), TOLERANCE_NS)
    similarity = umeyama(*path)
    posed, truth = pair_up(read_centers(out / "localized.txt"), read_centers(asked / "groundtruth.txt"),
                           TOLERANCE_NS)
    num_asked = sum(1 for line in (asked / "times.txt").read_text().splitlines() if line and line[0] != "#")
    return numpy.linalg.norm(transform(similarity, posed) - truth, axis=1), num_asked, same


def figures(errors, num_asked, same):
    return (f"{len(errors)} of {num_asked} pictures posed, error {100 * numpy.median(errors):.2f} cm in the median, "
            f"{100 * errors.max():.2f} at most; map.db {'unchanged' if same else 'CHANGED'}")


def second_lap(_quick):
    whole = render_tour("turntable2", NOISE, 1)
    first = drives.part_of(whole, "turntable2_lap1", 0, FIRST_LAP - 1)
    second = drives.part_of(whole, "turntable2_lap2_thin", FIRST_LAP, stride=5)
    errors, num_asked, same = localise("localise/turntable2", first, second)
    return same and len(errors) == num_asked and errors.max() <= 0.01, figures(errors, num_asked, same)


def fr1(quick):
    mapped = dataset("tum_fr1_xyz")
    mode = ["--mode", "parallax"]  # as for any video; 798 keyframes are adjusted for more than 14 minutes at the end
    if quick:
        mapped, mode = drives.part_of(mapped, "fr1_thin", stride=16), []
    asked = drives.part_of(dataset("tum_fr1_rpy"), "fr1_rpy_thin", stride=10)
    errors, num_asked, same = localise("localise/fr1", mapped, asked, *mode)
    # 70 pictures have a view in the map of all pictures; fewer are asked of the thin one.
    enough = len(errors) >= (50 if quick else 64)
    return same and enough and numpy.median(errors) <= 0.03, figures(errors, num_asked, same)


LINES = [
    Line("second_lap", "localisation, turntable2: every 5th picture of the second lap posed in the first, <= 1 cm",
         second_lap, False),
    Line("fr1", "localisation, tum_fr1_rpy every 10th in tum_fr1_xyz: >= 64 posed, median <= 3 cm", fr1, True),
]
