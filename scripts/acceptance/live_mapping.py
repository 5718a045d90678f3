"""A frontend and a mapping node that are fed from a bag, and ended in the middle."""

import contextlib
import pathlib
import signal
import subprocess
import tempfile

from acceptance.common import DEVEL, free_port
from acceptance.endings import (PATIENCE_S, Running, disk, end, environment, fill, frames_below,
                                names_in)

CLIENTS, CALLS = 6, 15


@contextlib.contextmanager
def master(home):
    """The environment of a ROS master."""
    port = free_port()
    env = environment(port, home)
    process = subprocess.Popen(["rosmaster", "--core", "-p", str(port)], env=env,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        yield env
    finally:
        process.terminate()
        process.wait(PATIENCE_S)


def ros(env, *words, check=False):
    """A command that knows our messages."""
    return subprocess.run([str(DEVEL / "env.sh"), *map(str, words)], env=env, capture_output=True, text=True,
                          timeout=PATIENCE_S, check=check).stdout


def num_maps(env):
    """Maps with frames, as the node tells them."""
    said = ros(env, "rosservice", "call", "/list_sessions")
    return said.count("num_keyframes: ") - said.count("num_keyframes: 0")


@contextlib.contextmanager
def mapping(env, out, bag):
    """A mapping node that has begun a map of the bag's drive."""
    frontend = dict(env, ROS_NAMESPACE="rovio1")
    with Running("mapping", f"_output_dir:={out}", env=env) as node, \
            Running("frontend", env=frontend), \
            subprocess.Popen(["rosbag", "play", "--quiet", "--wait-for-subscribers", str(bag), "--topics",
                              "/rovio1/image_raw/compressed", "/rovio1/camera_info"],
                             env=env, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as player:
        try:
            yield node
        finally:
            player.terminate()


def end_mapping(how, bag, size):
    with disk(size + (",ro" if how == "read-only" else "")) as out, tempfile.TemporaryDirectory() as home, \
            master(home) as env, mapping(env, out / "map", bag) as node:
        if how != "read-only" and not node.wait_until(lambda: num_maps(env) > 0):
            raise RuntimeError(f"mapping ended too soon: {node.said()[-300:]}")
        if how == "full":  # a full disk ends no node: it is ended then
            fill(out)
            how = "once"
        status, seconds = end(node, how, out)
        return status, seconds, node.said(), names_in(out), frames_below(out)


def folders(_quick):
    """What ~output_dir means, and export_map from several clients at once."""
    from acceptance.maps_kept import bag
    with tempfile.TemporaryDirectory() as home, master(home) as env:
        env["HOME"] = home
        with Running("mapping", "_output_dir:=maps", env=env) as node:
            status, _ = node.ended()
            refused = status == 1 and "output_dir: 'maps'" in node.said()
        with mapping(env, "~/maps", bag()) as node:
            if not node.wait_until(lambda: num_maps(env) > 0):
                raise RuntimeError(node.said()[-300:])
            failed = sum(export_from_clients(env))
            node.send(signal.SIGINT)
            status, _ = node.ended()
        written = (pathlib.Path(home) / "maps/trajectory.txt").exists()
    return refused and failed == 0 and status == 0 and written, (
        f"relative {'refused' if refused else 'TAKEN'}, {failed} of {CLIENTS * CALLS} calls failed, "
        f"ended with {status}, ~/maps {'written' if written else 'MISSING'}")


def export_from_clients(env):
    """Failed calls of each client."""
    script = ("import rospy\nfrom rovio_sfm.srv import ExportMap\n"
              "call = rospy.ServiceProxy('/export_map', ExportMap)\n"
              f"print(sum(call(name='same', overwrite=True).status.code != 0 for _ in range({CALLS})))\n")
    clients = [subprocess.Popen([str(DEVEL / "env.sh"), "/usr/bin/python3", "-c", script], env=env, text=True,
                                stdout=subprocess.PIPE) for _ in range(CLIENTS)]
    said = [client.communicate(timeout=PATIENCE_S)[0].strip() for client in clients]
    if not all(word.isdigit() for word in said):
        raise RuntimeError(f"a client failed: {said}")
    return [int(word) for word in said]
