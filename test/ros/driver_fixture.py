"""What the node tests of the driver share: a simulated robot, a driver, and ways to look at both."""

import os
import re
import signal
import subprocess
import threading
import time
import urllib.request

import cv2
import numpy
import roslib.packages
import rosgraph
import rospy


def program(name):
    """The path of one of our programs, in a devel or install space."""
    found = roslib.packages.find_node("rovio_sfm", name)
    if not found:
        raise RuntimeError("program %s is not built" % name)
    return found[0]


def wait_until(condition, timeout_s, period_s=0.05):
    """Whether the condition came true within the time."""
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(period_s)
    return bool(condition())


def write_images(folder, count):
    """Pictures of 640 x 480 with something to see, numbered."""
    random = numpy.random.RandomState(1)
    for i in range(count):
        small = random.randint(0, 255, (60, 80, 3), dtype=numpy.uint8)
        picture = cv2.resize(small, (640, 480), interpolation=cv2.INTER_LINEAR)
        cv2.imwrite(os.path.join(folder, "%04d.jpg" % i), picture)


class Simulator:
    """rovio_sim on a free port; faults by name, while it runs."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen(
            [program("rovio_sim"), "--port", "0"] + list(arguments),
            stdout=subprocess.PIPE, universal_newlines=True)
        line = self.process.stdout.readline()
        match = re.search(r"http://[^:]+:(\d+)", line)
        if not match:
            raise RuntimeError("rovio_sim does not listen: %r" % line)
        self.port = int(match.group(1))
        self.drain = threading.Thread(target=self.process.stdout.read, daemon=True)
        self.drain.start()

    def get(self, target):
        with urllib.request.urlopen("http://127.0.0.1:%d%s" % (self.port, target), timeout=10) as reply:
            return reply.read().decode()

    def fault(self, name, value):
        return self.get("/sim?quirk=%s&value=%s" % (name, value))

    def position(self):
        """x and y of the robot in the world, in metres: the truth."""
        text = re.search(r"world_from_base = (.*)", self.get("/sim?truth")).group(1)
        return [float(number) for number in text.split()[:2]]

    def stop(self):
        self.process.terminate()
        self.process.wait(20)


class Driver:
    """rovio_driver in a namespace of its own, with what it publishes."""

    def __init__(self, robot, port, parameters=None):
        base = "/%s/rovio_driver" % robot
        defaults = {
            "host": "127.0.0.1", "port": port, "mcu_rate_hz": 20.0,
            "http": {"first_byte_timeout_s": 1.0, "between_bytes_timeout_s": 1.0},
            "back_off": {"first_delay_s": 0.1, "max_delay_s": 1.0},
        }
        defaults.update(parameters or {})
        rospy.set_param(base, defaults)
        self.process = subprocess.Popen(
            [program("rovio_driver"), "__ns:=/" + robot, "__name:=rovio_driver"])

    def cpu_seconds(self):
        with open("/proc/%d/stat" % self.process.pid) as stat:
            fields = stat.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def is_alive(self):
        return self.process.poll() is None

    def stop(self, kind=signal.SIGTERM):
        if self.is_alive():
            self.process.send_signal(kind)
        return self.process.wait(20)


class Collector:
    """Keeps the messages of one topic."""

    def __init__(self, topic, kind):
        self.messages = []
        self.subscriber = rospy.Subscriber(topic, kind, self.messages.append, queue_size=100)

    def count(self):
        return len(self.messages)

    def grows_by(self, count, timeout_s):
        goal = self.count() + count
        return wait_until(lambda: self.count() >= goal, timeout_s)

    def last(self):
        return self.messages[-1]


def diagnostic(collector, part):
    """Level, sentence and values of the newest diagnostics of a part of the driver."""
    for array in reversed(collector.messages):
        for status in array.status:
            if status.name.endswith(part):
                return status.level, status.message, {v.key: v.value for v in status.values}
    return None, "", {}
