"""Data-set folders made of others: parts of a drive, and pictures spoilt."""

import io
import shutil

from acceptance.common import WORK


def part_of(folder, name, first=0, last=None, stride=1, black=()):
    """A folder with the pictures first … last (both included) of another, every stride-th; those
    whose index in the other is in black show nothing. Pictures are links."""
    out = WORK / f"drives/{name}"
    shutil.rmtree(out, ignore_errors=True)
    (out / "images").mkdir(parents=True)
    images = image_list(folder)
    last = len(images) - 1 if last is None else last
    chosen = range(first, last + 1, stride)
    lines = [f"{images[i][0]} {images[i][1]}" for i in chosen]
    (out / "times.txt").write_text("\n".join(lines) + "\n")
    for i in chosen:
        target = out / images[i][1]
        if i in black:
            target.write_bytes(black_picture())
        else:
            target.symlink_to((folder / images[i][1]).resolve())
    for other in folder.glob("*.txt"):
        if other.name != "times.txt" and not other.name.startswith("overlaps"):
            (out / other.name).symlink_to(other.resolve())
    return out


def image_list(folder):
    """(stamp, file) of every picture of a data set."""
    lines = (folder / "times.txt").read_text().splitlines()
    return [tuple(line.split()) for line in lines if line.strip() and not line.startswith("#")]


def black_picture():
    from PIL import Image  # matplotlib brings it; few lines need it
    buffer = io.BytesIO()
    Image.new("RGB", (640, 480)).save(buffer, "JPEG", quality=90)
    return buffer.getvalue()


def covisible_frames(folder, other_tour, min_share):
    """The pictures of a rendered tour that share so much with some picture of another."""
    shares = {}
    for line in (folder / f"overlaps_{other_tour}.txt").read_text().splitlines():
        if line.startswith("#"):
            continue
        frame, _, share, _ = line.split()
        shares[int(frame)] = max(shares.get(int(frame), 0.0), float(share))
    return {frame: share for frame, share in shares.items() if share >= min_share}
