"""Sets of pictures made of others by spoiling them: seeded, so that the same ones come out."""

import shutil
from typing import NamedTuple

import cv2
import numpy

from tables.runs import KEPT

STILL_FRAMES, STILL_NOISE = 500, 3.0  # grey levels


class DataSet(NamedTuple):
    """lines: of times.txt, odometry.txt, extrinsics.txt and groundtruth.txt, by file, one a picture."""
    folder: object
    lines: dict

    def pictures(self):
        return [cv2.imread(str(self.folder / line.split()[1])) for line in self.lines["times.txt"]]


def read(folder):
    return DataSet(folder, {name: [line for line in (folder / name).read_text().splitlines() if line[0] != "#"]
                            for name in ("times.txt", "odometry.txt", "extrinsics.txt", "groundtruth.txt")})


def write(name, source, pictures, lines, quality=95):
    """A data set of these pictures (None: left out) and lines."""
    folder = KEPT / "sets" / name
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "images").mkdir(parents=True)
    kept = [i for i, picture in enumerate(pictures) if picture is not None]
    for i in kept:
        cv2.imwrite(str(folder / f"images/{i:06d}.jpg"), pictures[i], (cv2.IMWRITE_JPEG_QUALITY, quality))
    stamps = [lines["times.txt"][i].split()[0] for i in kept]
    (folder / "times.txt").write_text("".join(f"{stamp} images/{i:06d}.jpg\n" for stamp, i in zip(stamps, kept)))
    for file in ("odometry.txt", "extrinsics.txt", "groundtruth.txt"):
        (folder / file).write_text("".join(lines[file][i] + "\n" for i in kept))
    (folder / "calibration.txt").write_text((source.folder / "calibration.txt").read_text())
    return folder


def jpeg(source, name, quality):
    return write(name, source, source.pictures(), source.lines, quality)


def noise(source, name, sigma):
    rng = numpy.random.default_rng(1)
    return write(name, source, [grains(picture, sigma, rng) for picture in source.pictures()], source.lines)


def grains(picture, sigma, rng):
    return clipped(picture + rng.normal(0.0, sigma, picture.shape)) if sigma else picture


def clipped(values):
    return numpy.clip(numpy.rint(values), 0, 255).astype(numpy.uint8)


def blur(source, name, sigma_px):
    pictures = [cv2.GaussianBlur(picture, (0, 0), sigma_px) for picture in source.pictures()]
    return write(name, source, pictures, source.lines)


def dropped(source, name, first, count):
    pictures = source.pictures()
    pictures[first:first + count] = [None] * count
    return write(name, source, pictures, source.lines)


def exposure(source, name, stops, every):
    """The light that arrives jumps up and down by so many stops; gamma 2.2."""
    gains = [2.0 ** (stops * (0, 1, 0, -1)[i // every % 4] / 2.2) for i in range(len(source.lines["times.txt"]))]
    return write(name, source, [clipped(gain * picture) for gain, picture in zip(gains, source.pictures())], source.lines)


def standing(source, name, at):
    """The robot stands still at that picture for 500 images, each with noise of its own."""
    rng = numpy.random.default_rng(2)
    pictures = source.pictures()
    seconds = 0.1 * STILL_FRAMES
    order = [*range(at), *[at] * STILL_FRAMES, *range(at + 1, len(pictures))]
    offsets = [*[0.0] * at, *(0.1 * i for i in range(STILL_FRAMES)), *[seconds] * (len(pictures) - at - 1)]
    lines = {file: [later(rows[i], offset) for i, offset in zip(order, offsets)] for file, rows in source.lines.items()}
    return write(name, source, [grains(pictures[i], STILL_NOISE, rng) for i in order], lines)


def later(line, seconds):
    stamp, rest = line.split(maxsplit=1)
    return f"{float(stamp) + seconds:.9f} {rest}"


def movers(source, name, first, last, step_px):
    """Something in front that fills a third of the picture and goes through it, of its own texture."""
    board, pictures = texture(480, 1600, seed=3), source.pictures()
    for i in range(first, last):
        height, width = pictures[i].shape[:2]
        left = (i - first) * step_px % (2 * width // 3)
        pictures[i][:, left:left + width // 3] = board[:height, :width // 3]
    return write(name, source, pictures, source.lines)


def texture(height, width, seed):
    """Grain of all sizes, with printed patches."""
    rng = numpy.random.default_rng(seed)
    total = numpy.zeros((height, width))
    for octave in range(7):
        small = rng.normal(0.0, 1.0, (max(2, height >> octave), max(2, width >> octave)))
        total += 2.0 ** (0.4 * octave) * cv2.resize(small, (width, height), interpolation=cv2.INTER_CUBIC)
    picture = numpy.repeat(clipped(128 + 30 * total / total.std())[:, :, None], 3, axis=2)
    for _ in range(height * width // 2500):
        corner, size = rng.integers(0, (width, height)), rng.integers(4, 40, 2)
        cv2.rectangle(picture, corner.tolist(), (corner + size).tolist(), rng.integers(20, 236, 3).tolist(), -1)
    return picture


def slip(source, name, first, last, forward, turn_deg):
    """The wheels tell `forward` times the way and a turn too many a picture: slipping, or one lifted."""
    poses = numpy.array([line.split()[1:4] for line in source.lines["odometry.txt"]], float)
    told = [poses[0]]
    for i in range(1, len(poses)):
        spoilt = first <= i < last
        moved = rotated(poses[i, :2] - poses[i - 1, :2], told[-1][2] - poses[i - 1, 2]) * (forward if spoilt else 1.0)
        turned = poses[i, 2] - poses[i - 1, 2] + (numpy.radians(turn_deg) if spoilt else 0.0)
        told.append(numpy.array([*(told[-1][:2] + moved), told[-1][2] + turned]))
    rows = [line.split() for line in source.lines["odometry.txt"]]
    odometry = [" ".join([row[0], *(f"{value:.9f}" for value in pose), *row[4:]]) for row, pose in zip(rows, told)]
    return write(name, source, source.pictures(), {**source.lines, "odometry.txt": odometry})


def rotated(vector, angle):
    c, s = numpy.cos(angle), numpy.sin(angle)
    return numpy.array([c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]])


def board(source, name, x_m, y_m, z_m, texel_m=0.002):
    """A flat printed board at that x stands in the room, from y_m[0] to y_m[1] and z_m[0] to z_m[1]."""
    numbers = [float(word) for word in (source.folder / "calibration.txt").read_text().splitlines()[-1].split()]
    width, height = int(numbers[9]), int(numbers[10])
    matrix = numpy.array([[numbers[0], 0, numbers[2]], [0, numbers[1], numbers[3]], [0, 0, 1]])
    pixels = numpy.stack(numpy.meshgrid(numpy.arange(width), numpy.arange(height)), -1).reshape(-1, 1, 2).astype(float)
    plane = cv2.undistortPoints(pixels, matrix, numpy.array(numbers[4:9]))[:, 0]
    rays = numpy.column_stack([plane, numpy.ones(len(plane))])
    shape = [round((high - low) / texel_m) for low, high in (z_m, y_m)]
    print_ = texture(*shape, seed=4)
    pictures = source.pictures()
    for picture, line in zip(pictures, source.lines["groundtruth.txt"]):
        center, turn = world_from_camera([float(word) for word in line.split()[1:8]])
        in_world = rays @ turn.T
        depth = (x_m - center[0]) / in_world[:, 0]
        at = center[1:] + depth[:, None] * in_world[:, 1:]
        where = (at - (y_m[0], z_m[0])) / texel_m
        inside = (depth > 0) & (where >= 0).all(1) & (where[:, 0] < shape[1] - 1) & (where[:, 1] < shape[0] - 1)
        seen = cv2.remap(print_, where[:, 0].reshape(height, width).astype(numpy.float32),
                         where[:, 1].reshape(height, width).astype(numpy.float32), cv2.INTER_LINEAR)
        mask = inside.reshape(height, width)
        picture[mask] = seen[mask]
    return write(name, source, pictures, source.lines)


def world_from_camera(pose):
    """Centre and rotation of tx ty tz qx qy qz qw."""
    x, y, z, w = pose[3:]
    return numpy.array(pose[:3]), numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
