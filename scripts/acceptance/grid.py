"""The lines about the occupancy grids of tours, against the simulator's true surfaces."""

import functools

import cv2
import numpy
import yaml
from scipy.spatial import cKDTree

from acceptance.common import NOISE, WORK, Line, map_images, render_tour
from acceptance.dense import true_surface
from evaluate_cloud import expected_within, fit_similarity, read_centres, read_surface, shown_with_contrast

TOURS = ("visionlab", "pipeline", "engineRoom0", "engineRoom1", "industrialArea", "turntable")
MIN_FREE_TRUE, MIN_FLOOR_FREE, MIN_OCCUPIED_TRUE, MIN_WALLS_MARKED = 0.95, 0.60, 0.80, 0.80
BAND_M, FLOOR_M = (0.04, 0.40), 0.02  # heights of what stands in the way, and of the floor
NEAR_PATH_M, NEAR_SURFACE_M = 2.0, 0.10
MAX_RANGE_M = 4.0  # of the rays that the grid is made of


def read_grid(folder):
    """As map_server's page says: -1 unknown, 0 free, 100 occupied; row 0 at the least y."""
    spec = yaml.safe_load((folder / "map.yaml").read_text())
    grey = cv2.imread(str(folder / spec["image"]), cv2.IMREAD_GRAYSCALE)[::-1].astype(float)
    p = grey / 255 if spec["negate"] else (255 - grey) / 255
    cells = numpy.where(p > spec["occupied_thresh"], 100, numpy.where(p < spec["free_thresh"], 0, -1))
    return cells, numpy.array(spec["origin"][:2]), spec["resolution"]


def truth_in_map(tour, folder, truth_folder):
    """The true surface's samples, their points in the map's frame, and the path's points."""
    estimate, truth = read_centres(folder / "trajectory.txt"), read_centres(truth_folder / "groundtruth.txt")
    stamps = sorted(set(estimate) & set(truth), key=float)
    path = numpy.array([estimate[s] for s in stamps])
    scale, rotation, shift = fit_similarity(numpy.array([truth[s] for s in stamps]), path)
    samples, _ = read_surface(true_surface(tour))
    return samples, scale * samples["x"].astype(float) @ rotation.T + shift, path


def shares_of_walls(walls, expected, occupied, path):
    """Of the cells in which something stands that keyframes show: with an occupied cell near; of those near the path; and
    the share that can be expected, from the samples' own (the best of a cell counts)."""
    cells, cell_of = numpy.unique(walls, axis=0, return_inverse=True)
    can_be = numpy.zeros(len(cells))
    numpy.maximum.at(can_be, cell_of, expected)
    marked = cKDTree(occupied).query(cells)[0] <= NEAR_SURFACE_M
    near = cKDTree(path[:, :2]).query(cells)[0] <= MAX_RANGE_M
    return marked.mean(), marked[near].mean(), can_be.mean()


def grid(tour, _quick):
    truth_folder, folder = render_tour(tour, NOISE, 1), WORK / f"grid/{tour}"
    map_images(f"grid/{tour}", [truth_folder], "--format", "tum,dense,grid")
    cells, origin, resolution = read_grid(folder)
    samples, points, path = truth_in_map(tour, folder, truth_folder)
    heights = samples["x"][:, 2]
    in_band = (heights > BAND_M[0]) & (heights < BAND_M[1])

    def centers(value):
        rows, columns = numpy.nonzero(cells == value)
        return origin + resolution * (numpy.stack([columns, rows], 1) + 0.5)
    stands = cKDTree(points[in_band][:, :2])
    free_true = (stands.query(centers(0))[0] > resolution / 2).mean()
    occupied_true = (stands.query(centers(100))[0] <= NEAR_SURFACE_M).mean()
    floor = points[heights < FLOOR_M][:, :2]
    floor = floor[(cKDTree(path[:, :2]).query(floor)[0] <= NEAR_PATH_M) & (stands.query(floor)[0] > resolution)]
    at = numpy.floor((floor - origin) / resolution).astype(int)
    inside = ((at >= 0) & (at < cells.shape[::-1])).all(1)
    floor_free = (cells[at[inside, 1], at[inside, 0]] == 0).sum() / len(floor)
    shown = in_band & shown_with_contrast(samples)
    walls = origin + resolution * (numpy.floor((points[shown][:, :2] - origin) / resolution) + 0.5)
    walls_marked, near_marked, walls_expected = shares_of_walls(
        walls, expected_within(samples[shown], NEAR_SURFACE_M), centers(100), path)
    holds = (free_true >= MIN_FREE_TRUE and floor_free >= MIN_FLOOR_FREE and occupied_true >= MIN_OCCUPIED_TRUE
             and walls_marked >= MIN_WALLS_MARKED)
    return holds, (f"{100 * free_true:.1f} % of the free cells are free, {100 * floor_free:.1f} % of the floor within "
                   f"{NEAR_PATH_M:.0f} m of the path is marked free, {100 * occupied_true:.1f} % of the occupied cells lie "
                   f"within {100 * NEAR_SURFACE_M:.0f} cm of a surface, {100 * walls_marked:.1f} % of the wall cells with "
                   f"contrast have one so near ({100 * near_marked:.1f} % within {MAX_RANGE_M:.0f} m of the path; "
                   f"{100 * walls_expected:.1f} % can be expected by half a pixel)")


LINES = [Line(f"grid_{tour}", f"the occupancy grid of {tour}, read as map_server reads it", functools.partial(grid, tour), False)
         for tour in TOURS]
