#!/usr/bin/python3
"""map_web beside mapping, over a real master and HTTP: what is mapped is shown, orders arrive."""

import base64
import http.client
import json
import os
import signal
import subprocess
import sys
import unittest

import cv2
import numpy
import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg
from sensor_msgs.msg import CompressedImage, Image

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "../../scripts")]
from demo_graph import free_ports
from driver_fixture import program, wait_until
from synthetic_drives import NUM_CAMERAS, World

WAIT_S = 90.0  # sanitizers and busy machines take their time
TOKEN = "0123456789abcdef"


class Page:
    """A map_web of its own, and a client of it."""

    def __init__(self, name, *parameters):
        self.port, self.since = free_ports(1), {}
        rospy.set_param("/%s/robots" % name, ["rovio1", "rovio2"])
        self.process = subprocess.Popen([program("map_web"), "__name:=" + name, "_port:=%d" % self.port,
                                         *parameters])
        if not wait_until(self.is_up, WAIT_S):
            raise RuntimeError("map_web does not answer")

    def is_up(self):
        if self.process.poll() is not None:
            raise RuntimeError("map_web ended with %d" % self.process.returncode)
        try:
            return self.ask("GET", "/")[0] == 200
        except OSError:
            return False

    def ask(self, method, path, body=None, **headers):
        """Status, revision and body."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=WAIT_S)
        connection.request(method, path, body, {name.replace("_", "-"): value for name, value in headers.items()})
        reply = connection.getresponse()
        return reply.status, reply.getheader("X-Revision"), reply.read()

    def news(self, path):
        """What changed since it was last asked for; None where nothing did."""
        status, revision, body = self.ask("GET", "%s?since=%s" % (path, self.since.get(path, "")))
        if status != 200:
            return None
        self.since[path] = revision
        return body

    def order(self, service, body, **headers):
        status, _, said = self.ask("POST", "/api/" + service, json.dumps(body),
                                   **{"Content_Type": "application/json", "X_Rovio_Token": TOKEN, **headers})
        return status, said.decode()

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(WAIT_S)


class MapWebNodeTest(unittest.TestCase):
    """Mapping lives on from test to test; each has a page, and a world, of its own."""

    def page(self, *parameters):
        page = Page(self._testMethodName, *parameters)
        self.addCleanup(page.process.kill)
        return page

    def wait(self, condition, what=None):
        self.assertTrue(wait_until(condition, WAIT_S), what)

    def drive(self):
        """Both robots, whose maps do not join."""
        publishers = [rospy.Publisher("/rovio%d/frames" % i, FrameEventMsg, queue_size=100) for i in (1, 2)]
        for publisher in publishers:
            self.wait(lambda p=publisher: p.get_num_connections() > 0)
        world = World(rospy.Time.now())
        for camera in range(NUM_CAMERAS):
            publishers[camera % 2].publish(world.frame(camera))

    def test_shows_what_is_mapped_and_orders_arrive(self):
        page = self.page("_allow_control:=true", "_token:=" + TOKEN)
        scene, latest = {}, {}

        def look():
            for path in ("/api/status", "/api/cloud", "/api/paths"):
                body = page.news(path)
                if body is not None:
                    latest[path] = json.loads(body)
                if body is not None and path == "/api/paths":
                    scene.update(latest[path]["changed"])

        def is_shown():
            look()
            return (latest.get("/api/cloud", {}).get("count", 0) > 100 and scene.get("mapping") is True
                    and {"place/1", "paths/path_1", "cameras/session_1", "paths/path_2"} <= set(scene)
                    and scene.get("apart"))

        look()
        self.drive()
        self.wait(is_shown, (latest, list(scene)))
        cloud = latest["/api/cloud"]
        self.assertEqual(len(base64.b64decode(cloud["positions"])), 12 * cloud["count"])
        self.assertIsNone(page.news("/api/cloud"))
        self.assertEqual({s["robot"] for s in latest["/api/status"]["sessions"]}, {"rovio1", "rovio2"})

        self.assertEqual(page.order("finish_session", {"robot": "rovio1"}, X_Rovio_Token="wrong")[0], 401)
        self.assertEqual(page.order("finish_session", {"robot": "rovio1"}, Origin="http://evil.example")[0], 403)
        self.assertEqual(page.ask("GET", "/api/status", Host="evil.example")[0], 403)
        status, said = page.order("finish_session", {"robot": "rovio1"})
        self.assertEqual((status, json.loads(said)["done"]), (200, True), said)
        status, said = page.order("unmerge_session", {"session": 77})
        self.assertEqual((status, json.loads(said)["done"]), (200, False), said)

        def has_finished():
            look()
            return {s["robot"]: s["state"] for s in latest["/api/status"]["sessions"]}["rovio1"] == "finished"
        self.wait(has_finished, latest["/api/status"])
        self.assertEqual(page.stop(), 0)

    def test_only_shows_unless_it_may_control(self):
        page = self.page()
        status, said = page.order("finish_session", {"robot": "rovio1"})
        self.assertEqual((status, said), (403, "this page only shows: map_web was started without allow_control\n"))

    def test_shows_pictures_while_somebody_looks(self):
        raw = rospy.Publisher("/rovio1/image", Image, queue_size=1)
        packed = rospy.Publisher("/rovio2/camera/compressed", CompressedImage, queue_size=1)
        picture = numpy.zeros((480, 640, 3), numpy.uint8)
        picture[:, :, 2] = 200
        pages = [(self.page(), "rovio1", raw,
                  Image(height=480, width=640, encoding="bgr8", step=1920, data=picture.tobytes())),
                 (Page("packed", "_image:=camera/compressed"), "rovio2", packed,
                  CompressedImage(format="jpeg", data=cv2.imencode(".jpg", picture)[1].tobytes()))]
        self.addCleanup(pages[1][0].process.kill)
        for page, robot, publisher, message in pages:
            path = "/api/camera/%s.jpg" % robot
            self.assertEqual(page.ask("GET", path)[0], 204)  # somebody looks
            self.wait(lambda p=publisher: p.get_num_connections() > 0)

            def is_shown(page=page, path=path, publisher=publisher, message=message):
                publisher.publish(message)
                return page.ask("GET", path)[0] == 200
            self.wait(is_shown)
            shown = cv2.imdecode(numpy.frombuffer(page.ask("GET", path)[2], numpy.uint8), cv2.IMREAD_COLOR)
            self.assertEqual(shown.shape, (240, 320, 3))
            self.assertGreater(shown[100, 100, 2], 150)


if __name__ == "__main__":
    rospy.init_node("map_web_node_test")
    rostest.rosrun("rovio_sfm", "map_web_node_test", MapWebNodeTest, sys.argv)
