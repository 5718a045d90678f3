"""The images of a data set, or every N-th of them, as both systems read them."""

import hashlib
import pathlib
from typing import NamedTuple

from read_plainly import reads


class ImageSet(NamedTuple):
    name: str
    folder: pathlib.Path  # of links to the images, by name
    stamps: dict  # name -> stamp, as written
    calibration: list  # fx fy cx cy k1 k2 p1 p2 k3 width height, as written
    fingerprint: str  # of names and bytes of the images, and of the calibration


@reads("a data set: lines STAMP IMAGE in times.txt, numbers in calibration.txt")
def read_set(source, stride, work):
    """Links every stride-th image of the data set into a folder below work."""
    source = pathlib.Path(source).resolve()
    lines = [line.split() for line in (source / "times.txt").read_text().splitlines()
             if line.strip() and not line.startswith("#")]
    calibration = next(line.split() for line in (source / "calibration.txt").read_text().splitlines()
                       if line.strip() and not line.startswith("#"))
    name = source.name if stride == 1 else f"{source.name}_every_{stride}"
    folder = work / name / "images"
    folder.mkdir(parents=True, exist_ok=True)
    digest, stamps = hashlib.sha256(" ".join(calibration).encode()), {}
    for stamp, path in lines[::stride]:
        image = source / path
        link = folder / image.name
        if not link.exists():
            link.symlink_to(image)
        stamps[image.name] = stamp
        digest.update(image.name.encode() + image.read_bytes())
    return ImageSet(name, folder, stamps, calibration, digest.hexdigest()[:16])
