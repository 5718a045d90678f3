"""Tables of chapter 3: what filters leave of features and matches."""

import cv2
import numpy

from tables import scope as settings
from tables.page import markdown
from tables.runs import points

TOUR = "visionlab"
FILTERS = ("ratio_share", "percentile_share", "one_to_one_share", "ransac_share", "guided_share")
FILTER_HEAD = ("features", "Lowe", "percentile", "one-to-one", "RANSAC", "with guided matching")
DENOISE = (3, 50, 50)  # diameter, sigma of colour and space: config/frontend.yaml, denoise


def funnel(summary):
    """Of an image and the one before it, in the mean: features, then matches after each filter."""
    matching = summary["matching"]
    if matching is None:
        return [None] * len(FILTER_HEAD)
    return [f"{matching['mean_features'] * share:.0f}"
            for share in (1.0, *(matching[name] for name in FILTERS))]


def milliseconds(summary, *stages):
    return f"{sum(summary['ms_per_frame'].get(stage, 0.0) for stage in stages):.0f}"


def bilateral(scope):
    """Table 3.1."""
    rows = []
    for name in ("surf", "sift"):
        for filtered in (True, False):
            s = scope.map(TOUR, settings.feature(name) if filtered else settings.without_denoising(name)).summary
            rows.append((f"{name}, {'filtered' if filtered else 'raw'}", *funnel(s)[::4], s["projections"], points(s),
                         s["rms_px"]))
    thesis = [("thesis, surf, filtered", "4303", "307", 100777, 24393, None),
              ("thesis, surf, raw", None, None, 41057, 13654, None)]
    return (markdown(("pictures", "features", "RANSAC", "projections", "points", "RMS, px"), thesis + rows)
            + "\n\n" + noise_reduction(scope))


def noise_reduction(scope):
    """How far the filter brings noisy pictures towards the same ones without noise."""
    noisy, clean = scope.pictures(TOUR), scope.pictures(TOUR, clean=True)
    before, after, harm = [], [], []
    for path in sorted((noisy / "images").iterdir())[::5]:
        seen, true = cv2.imread(str(path)), cv2.imread(str(clean / "images" / path.name))
        before.append(distance(seen, true))
        after.append(distance(cv2.bilateralFilter(seen, *DENOISE), cv2.bilateralFilter(true, *DENOISE)))
        harm.append(distance(cv2.bilateralFilter(true, *DENOISE), true))
    figures = [float(numpy.sqrt(numpy.mean(values))) for values in (before, after, harm)]
    return markdown(("RMS in grey levels", ""), zip(
        ("noise of a picture", "noise of the filtered picture", "what the filter takes from one without noise"), figures))


def distance(a, b):
    """Mean square, grey levels."""
    return float(numpy.mean((a.astype(float) - b.astype(float)) ** 2))


def features(scope):
    """Table 3.2."""
    rows = [("thesis, sift", "6830", "1290", "467", None, "359", None, None, None),
            ("thesis, surf", "4303", "951", "411", None, "307", None, None, None),
            ("thesis, orb", "3717", "579", "202", None, "157", None, None, None)]
    for name in settings.FEATURES:
        s = scope.map(TOUR, settings.feature(name)).summary
        rows.append((name, *funnel(s), milliseconds(s, "prepare", "extract"), milliseconds(s, "match")))
    return markdown(("features", *FILTER_HEAD, "ms an image to find", "ms an image to match"),
                    [(row[0], *row[1:]) for row in rows])


def after_the_map(scope):
    """Table 3.6, in kind: with the poses known no RANSAC is left to filter by."""
    rows = [("thesis, sift", "6706", "1555 of a neighbouring pair", None, None, None),
            ("thesis, surf", "4225", "999 of a neighbouring pair", None, None, None)]
    for name in settings.FEATURES:
        setting = settings.Setting(settings.feature(name).frontend, {}, settings.DENSIFIED.words)
        s = scope.map(TOUR, setting).summary
        d, images = s["densified"], s["registered_keyframes"]
        rows.append((name, f"{d['features'] / images:.0f}", f"{d['matches'] / images:.0f} of an image, all its pairs",
                     f"{100 * d['refused_f1'] / max(1, d['matches']):.1f} %", d["projections"], d["landmarks"]))
    return markdown(("features", "an image", "matches", "refused by f1", "projections", "points"), rows)


def matchers(scope):
    """Tables 3.3 and 3.4."""
    rows = [("thesis, kd-trees", "4303", "951", "411", None, "307", None, "185"),
            ("thesis, k-means tree", "4303", "946", "408", None, "304", None, "760"),
            ("thesis, brute force", "4303", "940", "404", None, "301", None, "1197")]
    for name in settings.MATCHERS:
        s = scope.map(TOUR, settings.matcher(name)).summary
        rows.append((name, *funnel(s), milliseconds(s, "match")))
    return markdown(("matcher", *FILTER_HEAD, "ms"), rows)


def percentile(scope):
    """§3.4.2: the percentile filter and its threshold."""
    rows = []
    for factor in (10, 2, 1.5, 1.25, 1.0, 0.8):
        s = scope.map(TOUR, settings.percentile(factor)).summary
        m = s["matching"]
        rows.append(("off (10)" if factor == 10 else f"{factor:g}", *funnel(s)[1:5],
                     f"{100 * (1 - m['ransac_share'] / m['one_to_one_share']):.1f} %", s["registered"], points(s),
                     s["projections"], s["rms_px"], millimetres(s)))
    return markdown(("max_mean_factor", *FILTER_HEAD[1:5], "of them outliers", "registered", "points", "projections",
                     "RMS, px", "error, mm"), rows)


def millimetres(summary):
    return None if summary["ate_rmse_m"] is None else 1000 * summary["ate_rmse_m"]
