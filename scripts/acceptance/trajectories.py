"""Camera paths of maps beside the true ones."""

import math

import numpy

from read_plainly import reads


@reads("a trajectory: stamp, position and quaternion a line")
def read_centers(path):
    """{stamp in ns: camera centre} of a TUM trajectory."""
    centers = {}
    for line in path.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            fields = line.split()
            centers[round(float(fields[0]) * 1e9)] = numpy.array(fields[1:4], float)
    return centers


def pair_up(estimate, truth, tolerance_ns=1000):
    """Two arrays of centres at the same stamps, in order of stamp."""
    known = numpy.array(sorted(truth))
    pairs = []
    for stamp in sorted(estimate):
        nearest = known[numpy.abs(known - stamp).argmin()]
        if abs(nearest - stamp) <= tolerance_ns:
            pairs.append((estimate[stamp], truth[nearest]))
    return numpy.array([p[0] for p in pairs]), numpy.array([p[1] for p in pairs])


def umeyama(source, target):
    """(scale, rotation, translation) that take source to target with the least squared error."""
    mean_source, mean_target = source.mean(0), target.mean(0)
    a, b = source - mean_source, target - mean_target
    u, singular, vt = numpy.linalg.svd(b.T @ a)
    sign = numpy.diag([1.0, 1.0, math.copysign(1.0, numpy.linalg.det(u @ vt))])
    rotation = u @ sign @ vt
    scale = (singular * numpy.diag(sign)).sum() / (a**2).sum()
    return scale, rotation, mean_target - scale * rotation @ mean_source


def transform(similarity, points):
    scale, rotation, translation = similarity
    return scale * points @ rotation.T + translation


def drive_paths(out, folders):
    """Per drive of a map that map_images wrote into out: (estimated, true) centres; empty for a
    drive that is in another map."""
    paths = []
    for i, folder in enumerate(folders):
        file = out / f"trajectory_folder_{i}.txt"
        if not file.exists() and len(folders) == 1:
            file = out / "trajectory.txt"
        estimate = read_centers(file) if file.exists() else {}
        truth = read_centers(folder / "groundtruth.txt")
        paths.append(pair_up(estimate, truth) if estimate else (numpy.zeros((0, 3)),) * 2)
    return paths


def scale_ratio(out, folders, last=20):
    """The scale of the first drive over that of the last frames of the second one, each aligned
    with the truth alone."""
    (first, true_first), (second, true_second) = drive_paths(out, folders)
    if len(first) < 3 or len(second) < last:
        return None
    return (umeyama(first, true_first)[0]
            / umeyama(second[-last:], true_second[-last:])[0])
