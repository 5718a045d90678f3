"""Section 6 of the third stage: bags, recorded, replayed and made."""

import re
import resource
import signal

from acceptance.common import DEVEL, Line, fresh_folder
from acceptance.users import Master, case, ended, judge, program, says

REPLAY = ("--mode", "every", "--places", "none")
METRES, NOT_METRES = r"in metres", r"^not metric: "

# Appends what a mapper published while an older bag was recorded.
ADD_WHAT_NODES_SAID = """
import sys, rosbag, rospy
from geometry_msgs.msg import TransformStamped, Twist
from rovio_sfm.msg import FrameEventMsg
from tf2_msgs.msg import TFMessage
edge = TransformStamped()
edge.header.frame_id, edge.child_frame_id = "map", "session_1/map"
edge.transform.translation.x, edge.transform.rotation.w = 99.0, 1.0
with rosbag.Bag(sys.argv[1]) as bag:
    edge.header.stamp = rospy.Time(bag.get_start_time() + 0.01)
with rosbag.Bag(sys.argv[1], "a") as bag:
    bag.write("/tf", TFMessage([edge]), edge.header.stamp)
    bag.write("/rovio1/frames", FrameEventMsg(), edge.header.stamp)
    bag.write("/rovio1/cmd_vel", Twist(), edge.header.stamp)
"""
INPUTS = ("camera_info", "odom", "image_raw/compressed", "image_raw")
COUNT_EDGES = """
import sys, rosbag
with rosbag.Bag(sys.argv[1]) as bag:
    for _, message, _ in bag.read_messages("/tf"):
        print(*(t.child_frame_id for t in message.transforms))
"""


def replay(bag, *options):
    """What replay says of a bag, and how many images it posed."""
    out = fresh_folder("bags/replay")
    result = program("replay", bag, "--out", out, *REPLAY, *options)
    trajectory = out / "trajectory.txt"
    lines = trajectory.read_text().splitlines() if trajectory.exists() else []
    return result, sum(1 for line in lines if not line.startswith("#"))


def maps(name, count, *options, says_also=""):
    result, num_posed = replay(case(f"bags/{name}.bag"), *options)
    what, holds, figure = says(name, result, {0}, says_also)
    return what, holds and num_posed == count, f"{num_posed} posed, {figure}"


def refuses(name, *patterns):
    result, _ = replay(case(f"bags/{name}.bag"))
    return says(name, result, {1, 2}, *patterns)


def each_bag(_quick):
    calibration = case("good7") / "calibration.txt"
    return judge([
        maps("good", 8),
        maps("rational_polynomial_zeros", 8), maps("plumb_bob_8_zeros", 8), maps("roi_full_image", 8),
        maps("raw_8UC1", 8), maps("raw_mono16", 8), maps("raw_yuv422_yuy2", 8),
        refuses("camera_info_other_size", "1536 ?x ?1024", "768 ?x ?512"),
        refuses("camera_info_zero", "uncalibrated", "--calibration"),
        maps("camera_info_zero", 8, "--calibration", calibration),
        refuses("no_camera_info", "camera_info", "--calibration"),
        maps("no_camera_info", 8, "--calibration", calibration),
        refuses("topics_nested", "--image-topic", "/camera/color/image_raw"),
        maps("topics_nested", 8, "--image-topic", "/camera/color/image_raw"),
        refuses("topics_capital", "--image-topic", "/Robot1/image_raw"),
        maps("topics_capital", 8, "--image-topic", "/Robot1/image_raw"),
        refuses("unclosed", "rosbag reindex .*unclosed.bag")])


def metric_or_why(_quick):
    def why(name, *patterns):
        result, _ = replay(case(f"bags/{name}.bag"))
        return says(name, result, {0}, NOT_METRES, *patterns)

    def metric(name, *options):
        result, _ = replay(case(f"bags/{name}.bag"), *options)
        what, holds, figure = says(f"{name} {' '.join(options)}".strip(), result, {0}, METRES)
        return what, holds and "not metric" not in result.text, figure

    return judge([
        metric("sim_good"),
        why("sim_frames_unprefixed", "no tf between rovio1/base_link", "base_link", "--base-frame"),
        metric("sim_frames_unprefixed", "--base-frame", "base_link"),
        why("sim_base_footprint", "no tf between", "frames in the bag: base_footprint,", "--base-frame"),
        metric("sim_base_footprint", "--base-frame", "base_footprint"),
        why("sim_no_tf", "no tf between", "frames in the bag: none"),
        why("sim_odom_quaternion_zero", "odometry was refused", "orientation"),
        why("sim_odom_quaternion_101", "odometry was refused", "orientation")])


def limit_files():
    """As a full disk, but for anybody: a write beyond fails."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (300 << 10, 300 << 10))


def makes_bags(_quick):
    folder = fresh_folder("bags/made")
    folder.mkdir(parents=True)
    bag = folder / "a.bag"
    outcomes = [says("disk full", program("images_to_bag", case("good7_t1"), bag, preexec_fn=limit_files),
                     {1}, "a.bag", "too large|no space left")]
    outcomes.append(("nothing left behind", not list(folder.iterdir()),
                     [str(path) for path in folder.iterdir()]))
    outcomes.append(says("from zero", program("images_to_bag", case("good7"), bag), {0}, "7 images"))
    result, num_posed = replay(bag)
    outcomes.append(("and replayed", num_posed == 7, f"{num_posed} of 7 posed: {result.text[-200:]}"))
    outcomes.append(says("twice", program("images_to_bag", case("good7"), bag), {1}, "exists already"))
    return judge(outcomes)


def publish_tf(master, parent, child):
    return master.start("rostopic", "pub", "-r", "20", "/tf", "tf2_msgs/TFMessage",
                        f"{{transforms: [{{header: {{frame_id: {parent}}}, child_frame_id: {child}, "
                        "transform: {rotation: {w: 1.0}}}]}")


def records(_quick):
    """Inputs only, several robots, never over a file."""
    folder = fresh_folder("bags/recorded")
    folder.mkdir(parents=True)
    bag = folder / "with blank.bag"
    outcomes = []
    with Master("record") as master:
        publish_tf(master, "map", "session_1/map")
        publish_tf(master, "session_1/map", "rovio1/odom")
        publish_tf(master, "rovio1/odom", "rovio1/base_link")
        record = ("roslaunch", "rovio_sfm", "record.launch", "robot:=rovio1, rovio2", f"bag:={bag}")
        recorder = master.start(*record)
        listens = master.wait_for(
            lambda: "/rovio2/image_raw/compressed" in master.run("rosnode", "info", "/record").text, 60)
        master.run("rostopic", "echo", "-n", "20", "/tf_inputs")
        master.interrupt(recorder)
        edges = ended(DEVEL / "env.sh", "/usr/bin/python3", "-c", COUNT_EDGES, bag).text.split()
        outcomes.append(("two robots", listens, master.text_of(recorder)[-300:]))
        outcomes.append(("inputs only", len(edges) > 0 and set(edges) == {"rovio1/base_link"},
                         f"{len(edges)} edges: {sorted(set(edges))[:5]}"))
        before = bag.stat().st_size if bag.exists() else 0
        again = master.run(*record)
        outcomes.append(says("no file replaced", again, {0, 1}, "is there already"))
        outcomes.append(("the older one whole", before > 0 and bag.stat().st_size == before, before))
    return judge(outcomes)


def replays_live(_quick):
    """Two robots out of two bags, one with an earlier map; the master keeps no use_sim_time."""
    folder = fresh_folder("bags/live")
    folder.mkdir(parents=True)
    bags = [folder / "a.bag", folder / "b.bag"]
    outcomes = []
    for bag, robot in zip(bags, ("rovio1", "rovio2")):
        program("images_to_bag", case("sim16"), bag, "--robot", robot)
    ended(DEVEL / "env.sh", "/usr/bin/python3", "-c", ADD_WHAT_NODES_SAID, bags[0])
    result, _ = replay(bags[0])
    outcomes.append(says("an older bag's map", result, {0}, "1 transform of the map .* left out"))
    with Master("replay") as master:
        replaying = master.start(
            "roslaunch", "rovio_sfm", "replay.launch", "robot:=rovio1,rovio2", "mode:=every",
            f"bag:={bags[0]} {bags[1]}", "places:=false", "rate:=0.5", f"output_dir:={folder / 'map'}")

        def is_mapped():
            sessions = master.run("rosservice", "call", "/list_sessions").text
            return "rovio1" in sessions and "rovio2" in sessions

        def played():
            return set(re.findall(r"\* (\S+) \[", master.run("rosnode", "info", "/play").text))
        inputs = {f"/{robot}/{topic}" for robot in ("rovio1", "rovio2") for topic in INPUTS}
        plays = master.wait_for(lambda: "/rovio2/camera_info" in played(), 60)
        others = played() - inputs - {"/clock", "/rosout", "/tf_recorded"}
        outcomes.append(("inputs alone are played", plays and not others, others))
        outcomes.append(("two robots, two bags", master.wait_for(is_mapped, 180),
                         master.text_of(replaying)[-300:]))
        status = master.interrupt(replaying)
        text = master.text_of(replaying)
        outcomes.append(("map's tf left out", "are left out" in text, text[-300:]))
        outcomes.append(("ends", status == 0, status))
        sim_time = master.run("rosparam", "get", "/use_sim_time")
        outcomes.append(("no use_sim_time", sim_time.status != 0, sim_time.text.strip()[-200:]))
    return judge(outcomes)


LINES = [
    Line("bags_each", "6. each bag is mapped, or what it lacks is said, with the option that gives it",
         each_bag, False),
    Line("bags_metric", "6. a bag with odometry gives metres, or one sentence says why not",
         metric_or_why, False),
    Line("bags_made", "6. images_to_bag: stamps from zero, a full disk, nothing left behind, nothing replaced",
         makes_bags, True),
    Line("bags_recorded", "6. record.launch: inputs only, several robots, no file replaced", records, False),
    Line("bags_replayed", "6. replay.launch: several robots and bags, an earlier map left out, no use_sim_time",
         replays_live, False),
]
