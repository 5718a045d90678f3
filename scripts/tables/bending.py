"""Whether an event bent a map: the rule of docs/robustness.md."""

import math
from typing import NamedTuple, Optional

import numpy

from acceptance.trajectories import pair_up, read_centers, transform, umeyama

LEAST_POSES = 5  # of a part that is judged
MAX_SCALE_GAP = 0.03


class Verdict(NamedTuple):
    bent: bool  # any of the maps
    before_m: Optional[float]  # error of the largest map's part before the event
    after_m: Optional[float]  # of its part after it; None: another map begins there, or none
    scale_ratio: Optional[float]  # of the two


def judge(folder, pictures, event, bound_m):
    """folder: what map_images wrote; event: (stamp of the first spoilt frame, of the last), s, or None:
    then a whole map is `before`."""
    truth = read_centers(pictures / "groundtruth.txt")
    paths = [folder / "trajectory.txt", *sorted(folder.glob("map_*/trajectory.txt"))]
    verdicts = [judge_map(read_centers(path), truth, event, bound_m) for path in paths if path.exists()]
    if not verdicts:
        return Verdict(False, None, None, None)
    return verdicts[0]._replace(bent=any(verdict.bent for verdict in verdicts))


def judge_map(centers, truth, event, bound_m):
    first, last = (math.inf, math.inf) if event is None else (1e9 * event[0], 1e9 * event[1])
    before = aligned({stamp: center for stamp, center in centers.items() if stamp < first}, truth)
    after = aligned({stamp: center for stamp, center in centers.items() if stamp > last}, truth)
    ratio = after[1] / before[1] if before and after else None
    bent = any(part and part[0] > bound_m for part in (before, after))
    bent = bent or (ratio is not None and abs(math.log(ratio)) > math.log(1 + MAX_SCALE_GAP))
    return Verdict(bent, before and before[0], after and after[0], ratio)


def aligned(estimate, truth):
    """(RMS error in m, scale) after a similarity of its own; None for too few poses."""
    if len(estimate) < LEAST_POSES:
        return None
    ours, true = pair_up(estimate, truth)
    similarity = umeyama(ours, true)
    return float(numpy.sqrt(numpy.mean(numpy.sum((transform(similarity, ours) - true) ** 2, axis=1)))), similarity[0]
