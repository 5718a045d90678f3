"""Section 7 of the third stage: files as others write them, and scripts as others call them."""

import os
import shutil
import tempfile

from acceptance.common import DEVEL, PROGRAMS, ROOT, THREADS, Line, fresh_folder
from acceptance.users import Master, case, ended, judge, program, says

QUICK_MODEL = ("--words", "50", "--features", "200")


def poses_of(out):
    trajectory = out / "trajectory.txt"
    lines = trajectory.read_text().splitlines() if trajectory.exists() else []
    return sum(1 for line in lines if not line.startswith("#"))


def maps(folder, count, *says_also, name=""):
    out = fresh_folder("shell/map")
    result = program("map_images", folder, "--out", out, "--places", "none", "--threads", THREADS)
    what, holds, figure = says(name or folder.name, result, {0}, *says_also)
    num_posed = poses_of(out)
    return what, holds and num_posed == count, f"{num_posed} of {count} posed, {figure}"


def in_nanoseconds():
    """The reference with stamps as EuRoC writes them."""
    folder = fresh_folder("shell/nanoseconds")
    shutil.copytree(case("good7"), folder)
    times = folder / "times.txt"
    lines = [line.split(maxsplit=1) for line in times.read_text().splitlines()]
    times.chmod(0o644)
    times.write_text("".join(f"{1403636579763555584 + i * 10**9} {name}\n"
                             for i, (_, name) in enumerate(lines)))
    return folder


def num_landmarks(folder):
    out = fresh_folder("shell/landmarks")
    program("map_images", folder, "--out", out, "--places", "none", "--threads", THREADS)
    cloud = (out / "cloud.ply").read_bytes()
    return int(cloud.split(b"element vertex ")[1].split()[0])


def folders(_quick):
    outcomes = [maps(case("good7"), 7), maps(case("crlf_bom"), 7), maps(case("times_scientific"), 7),
                maps(case("spaces_in_names"), 7), maps(in_nanoseconds(), 7),
                maps(case("times_equal_pair"), 6, "times.txt: 1 image left out"),
                maps(case("png12in16"), 7)]
    eight, twelve = num_landmarks(case("good7")), num_landmarks(case("png12in16"))
    outcomes.append(("12 bits in 16", twelve >= 0.8 * eight, f"{twelve} landmarks, {eight} of 8 bits"))
    for name, why in (("half_size_images", "384 ?x ?256"), ("calibration_other_size", "1536 ?x ?1024"),
                      ("webp", "JPEG or PNG"), ("black", "")):
        result = program("map_images", case(name), "--out", fresh_folder("shell/none"), "--places", "none")
        outcomes.append(says(name, result, {1, 2}, why))
    return judge(outcomes)


# What root may not, either: read a file whose mode forbids it.
AS_ANYBODY = ("setpriv", "--bounding-set", "-dac_override,-dac_read_search") if os.geteuid() == 0 else ()


def unreadable(_quick):
    """A picture that may not be read, and one that is no file."""
    outcomes = []
    for what, reason in (("no permission", "Permission denied"), ("a pipe", "no file")):
        folder = fresh_folder("shell/unreadable")
        shutil.copytree(case("unreadable_image"), folder)
        picture = folder / "images/000005.jpg"
        picture.chmod(0)
        if what == "a pipe":
            picture.unlink()
            os.mkfifo(picture)
        out = fresh_folder("shell/map")
        result = ended(*AS_ANYBODY, PROGRAMS / "map_images", folder, "--out", out, "--places", "none")
        what, holds, figure = says(what, result, {0, 1}, f"000005.jpg.*{reason}|{reason}.*000005.jpg")
        outcomes.append((what, holds and (result.status == 1 or poses_of(out) >= 6), figure))
    return judge(outcomes)


def renamed_to_jpg(dataset):
    """Its pictures, of one size."""
    folder = fresh_folder("shell/noise")
    folder.mkdir(parents=True)
    for picture in (dataset / "images").iterdir():
        shutil.copy(picture, folder / (picture.stem + ".JPG"))
    return folder


def photos(quick):
    work = fresh_folder("shell/photos")
    work.mkdir(parents=True)
    outcomes = []
    for number in range(1 if quick else 6):  # a race: once is not enough
        result = program("train_places", case("photos_one_broken"), "--out", work / f"{number}.places",
                         *QUICK_MODEL)
        outcomes.append(says(f"one broken photo, {number + 1}", result, {0}, "left out: .*000004.jpg",
                             "train_places: 9 images"))
    outcomes.append(says("few .JPG", program("train_places", case("few_photos"), "--out",
                                             work / "few.places", *QUICK_MODEL), {0}, "6 images"))
    outcomes.append(says("noise of .JPG", program("measure_noise", renamed_to_jpg(case("good7"))), {0},
                         "pictures 7"))
    outcomes.append(says("noise of other sizes", program("measure_noise", case("few_photos")), {1},
                         "000001.JPG: other size than the first"))
    broken = program("evaluate_places", "--query", case("good7_broken"), "--database",
                     case("good7_broken"), "--out", work / "evaluated")
    outcomes.append(says("evaluate_places", broken, {0}, r"left out: .*00000\d\.jpg"))
    for name in ("chessboard_JPG", "chessboard_mixed_case"):
        result = program("calibrate_camera", case(name), "--columns", 9, "--rows", 6, "--out",
                         work / f"{name}.yaml")
        outcomes.append(says(name, result, {0}, "rms 0"))
    boards = fresh_folder("shell/boards")
    shutil.copytree(case("chessboard_JPG"), boards)
    (boards / "left15.JPG").write_bytes(b"no picture")
    outcomes.append(says("a broken chessboard", program(
        "calibrate_camera", boards, "--columns", 9, "--rows", 6, "--out", work / "boards.yaml"),
        {0}, "left out: .*left15.JPG", "rms 0"))
    return judge(outcomes)


def trajectory(_quick):
    truth = case("evo_tum.txt")
    return judge([says("evo's file", program("evaluate_trajectory", truth, truth), {0})])


def scripts_anywhere(_quick):
    """CDPATH set, through a symlink, from another folder, --out=DIR, blanks."""
    with tempfile.TemporaryDirectory(prefix="a user's ") as name:
        link = os.path.join(name, "map")
        os.symlink(ROOT / "scripts/map_images", link)
        os.symlink(ROOT, os.path.join(name, "tree"))
        environment = dict(os.environ, CDPATH=f".:{name}:/")
        outcomes = []
        for what, script in (("a symlink", link), ("a linked tree", os.path.join(name, "tree/scripts/map_images"))):
            for out in (("--out=an out",), ("--out", "an out")):
                shutil.rmtree(os.path.join(name, "an out"), ignore_errors=True)
                result = ended(script, case("good7"), *out, "--places", "none", cwd=name, env=environment)
                drawn = os.path.exists(os.path.join(name, "an out/map.png"))
                what_now, holds, figure = says(f"{what}, {out[0].split('=')[0]}{'=' * ('=' in out[0])}", result,
                                               {0}, "wrote /.*/an out/map.png")
                outcomes.append((what_now, holds and drawn, figure))
        for script in ("check_layers", "check_docs"):
            link = os.path.join(name, script)
            os.symlink(ROOT / "scripts" / script, link)
            outcomes.append(says(script, ended(link, cwd=name, env=environment), {0}))
        shown = ended("bash", "-c", '. "$0"; echo "<$root>"', os.path.join(name, "tree/scripts/environment"),
                      cwd=name, env=environment)
        outcomes.append(("environment", shown.text.strip() == f"<{ROOT}>", shown.text.strip()))
    return judge(outcomes)


CAMERA = ("{camera_info: {width: 640, height: 480, distortion_model: plumb_bob, D: [0.1, 0, 0, 0, 0], "
          "K: [%d, 0, 320, 0, 500, 240, 0, 0, 1], R: [1, 0, 0, 0, 1, 0, 0, 0, 1], "
          "P: [500, 0, 320, 0, 0, 500, 240, 0, 0, 0, 1, 0]}}")


def calibrations(_quick):
    """set_camera_info of two robots: below $ROS_HOME, each its own, taken up at the next start."""
    shipped = ROOT / "config/camera/rovio_640x480.yaml"
    before = shipped.read_bytes()
    outcomes = []
    with Master("calibrations") as master:
        for robot, focal in (("rovio1", 501), ("rovio2", 502)):
            driver = master.start("roslaunch", "rovio_sfm", "driver.launch", f"robot:={robot}",
                                  "host:=127.0.0.1", "port:=9")
            master.wait_for(lambda: f"/{robot}/set_camera_info" in master.run("rosservice", "list").text, 60)
            reply = master.run("rosservice", "call", f"/{robot}/set_camera_info", CAMERA % focal)
            nonsense = master.run("rosservice", "call", f"/{robot}/set_camera_info", "{}")
            refused = "success: False" in nonsense.text and "K: uncalibrated" in nonsense.text
            outcomes.append(("nonsense is refused", refused, nonsense.text.strip()[-200:]))
            master.interrupt(driver)
            written = master.home / f"camera_info/{robot}.yaml"
            holds = "success: True" in reply.text and written.exists() and str(focal) in written.read_text()
            outcomes.append((robot, holds, reply.text.strip()[-200:]))
        names = sorted(path.name for path in (master.home / "camera_info").glob("*"))
        outcomes.append(("each its own", names == ["rovio1.yaml", "rovio2.yaml"], names))
    outcomes.append(("the package's is left alone", shipped.read_bytes() == before, "written"))
    for name in ("driver", "rovio"):
        arguments = ended(DEVEL / "env.sh", "roslaunch", "rovio_sfm", f"{name}.launch", "--ros-args")
        outcomes.append(says(f"{name}.launch", arguments, {0}, "camera_info_url"))
    return judge(outcomes)


LINES = [
    Line("files_folders", "7. folders as others write them are mapped, or what is wrong is said", folders, True),
    Line("files_unreadable", "7. an image that cannot be read costs that image, or is found before", unreadable,
         True),
    Line("files_photos", "7. a bad photo costs the photo, named; .JPG is .jpg", photos, True),
    Line("files_trajectory", "7. a trajectory as evo and numpy write it is read", trajectory, True),
    Line("shell_scripts", "7. scripts run with CDPATH, through symlinks, from anywhere, with --out=DIR",
         scripts_anywhere, True),
    Line("shell_calibrations", "7. set_camera_info writes below $ROS_HOME, per robot", calibrations, False),
]
