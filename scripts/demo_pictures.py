"""Whether a picture of rviz shows a map: figures instead of a glance."""

import cv2

# Where the 3D view lies in the picture, as shares of its width and height: inside the docks.
VIEW = {"left": 0.29, "right": 0.98, "top": 0.08, "bottom": 0.95}
MIN_COLOUR_DIFFERENCE = 30  # of a pixel's channels, of 255; background, grid and white have less
MIN_COLOURED_SHARE = 0.005


def coloured_share(path):
    """Share of the view's pixels that have a colour: points, paths and cameras, not the empty floor."""
    picture = cv2.imread(str(path))
    if picture is None:
        raise RuntimeError(f"{path}: expected a picture")
    height, width = picture.shape[:2]
    view = picture[int(VIEW["top"] * height):int(VIEW["bottom"] * height),
                   int(VIEW["left"] * width):int(VIEW["right"] * width)]
    difference = view.max(axis=2).astype(int) - view.min(axis=2)
    return float((difference >= MIN_COLOUR_DIFFERENCE).mean())
