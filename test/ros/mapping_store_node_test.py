#!/usr/bin/python3
"""Mapping killed without a warning goes on with its maps; save_map and load_map."""

import os
import shutil
import signal
import sys
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg, MapStatus, PlaceMatchMsg, Status
from rovio_sfm.srv import GetFrames, LoadMap, Reset, SaveMap

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import World

WAIT_S = 90.0  # sanitizers and busy machines take their time
NODE = "/mapping"
TOPICS = {"/rovio1/frames", "/rovio2/frames", "/place_matches"}
ROBOTS = ("rovio1", "rovio2")


def ask_node(method):
    """What the running mapping answers to a call of ROS's slave API; None if it is not there."""
    try:
        uri = rosgraph.Master(rospy.get_name()).lookupNode(NODE)
        return getattr(xmlrpc.client.ServerProxy(uri), method)(rospy.get_name())[2]
    except (OSError, rosgraph.MasterException, xmlrpc.client.Error):
        return None


def saved(status, robot):
    """How many frames of a robot's drive no crash can take."""
    return max((i.index + 1 for i in status.saved_up_to if i.drive.robot == ROBOTS[robot]), default=0)


def num_keyframes(status, robot):
    return sum(s.num_keyframes for s in status.sessions if s.drive.robot == ROBOTS[robot])


class MappingStoreTest(unittest.TestCase):
    """The node starts once for all tests; each drives through a world of its own."""

    num_worlds = 0

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(rospy.get_param("/mapping/output_dir"), ignore_errors=True)

    def setUp(self):
        rospy.wait_for_service("/reset", WAIT_S)
        self.assertEqual(rospy.ServiceProxy("/reset", Reset)(True).status.code, Status.OK)
        self.maps = Collector("/map_status", MapStatus)
        self.wait_for(lambda s: not s.sessions)  # not what was before the reset
        self.frames = [rospy.Publisher("/%s/frames" % robot, FrameEventMsg, queue_size=100)
                       for robot in ROBOTS]
        self.matches = rospy.Publisher("/place_matches", PlaceMatchMsg, queue_size=10)
        self.wait_until_heard()
        type(self).num_worlds += 1
        self.world = World(rospy.Time.now(), seed=self.num_worlds)

    def wait_for(self, condition):
        self.assertTrue(wait_until(lambda: self.maps.messages and condition(self.maps.last()), WAIT_S),
                        self.maps.messages[-1:])
        return self.maps.last()

    def wait_until_heard(self):
        def listens():
            links = ask_node("getBusInfo") or []
            return TOPICS <= {link[4] for link in links if link[2] == "i"}
        self.assertTrue(wait_until(listens, WAIT_S))
        publishers = self.frames + [self.matches]
        self.assertTrue(wait_until(lambda: all(p.get_num_connections() == 1 for p in publishers), WAIT_S))

    def drive(self, robot, first, last):
        for index in range(first, last):
            self.frames[robot].publish(self.world.frame(2 * index + robot))
        return self.wait_for(lambda s: num_keyframes(s, robot) == last and saved(s, robot) == last)

    def kill_node(self):
        """Without a chance to say goodbye; returns once another one runs, which roslaunch started."""
        killed = ask_node("getPid")
        os.kill(killed, signal.SIGKILL)
        self.assertTrue(wait_until(lambda: ask_node("getPid") not in (None, killed), WAIT_S))
        self.maps = Collector("/map_status", MapStatus)  # of the new one alone
        self.wait_until_heard()

    def test_a_killed_mapping_goes_on_with_its_maps(self):
        before = self.drive(0, 0, 10)
        self.kill_node()
        after = self.wait_for(lambda s: s.sessions)
        self.assertEqual([m.num_landmarks for m in after.maps],
                         [m.num_landmarks for m in before.maps])
        self.assertEqual(after.saved_up_to, before.saved_up_to)
        page = rospy.ServiceProxy("/get_frames", GetFrames)(self.world.frame_id(2 * 3), 5)
        self.assertEqual([frame.id.index for frame in page.frames], [3, 4, 5, 6, 7])
        self.assertEqual(page.frames[0].descriptors, self.world.frame(2 * 3).descriptors)
        self.drive(0, 10, 16)
        self.drive(1, 0, 10)
        self.matches.publish(self.world.place_match(2 * 8 + 1, 2 * 8))
        self.wait_for(lambda s: len(s.maps) == 1)
        rospy.ServiceProxy("/save_map", SaveMap)("merged.db", True)  # returns once all is on the disk
        self.kill_node()
        self.assertEqual(len(self.wait_for(lambda s: s.sessions).maps), 1)

    def test_maps_are_saved_while_mapping_goes_on_and_loaded_again(self):
        saved_status = self.drive(0, 0, 10)
        save = rospy.ServiceProxy("/save_map", SaveMap)
        name = "saved_%d.db" % self.num_worlds
        answer = save(name, False)
        self.assertEqual(answer.status.code, Status.OK, answer.status.message)
        self.assertTrue(os.path.isfile(answer.file))
        self.assertEqual(save(name, False).status.code, Status.ALREADY_EXISTS)
        self.assertEqual(save("map.db", True).status.code, Status.INVALID_ARGUMENT)
        self.assertEqual(save("../x.db", True).status.code, Status.INVALID_ARGUMENT)
        self.drive(0, 10, 16)
        load = rospy.ServiceProxy("/load_map", LoadMap)
        self.assertEqual(load(name, False).status.code, Status.INVALID_ARGUMENT)
        self.assertEqual(load("none.db", True).status.code, Status.NOT_FOUND)
        answer = load(name, True)
        self.assertEqual(answer.status.code, Status.OK, answer.status.message)
        self.assertTrue(os.path.isfile(answer.put_aside))
        status = self.wait_for(lambda s: num_keyframes(s, 0) == 10)
        self.assertEqual(status.maps[0].num_landmarks, saved_status.maps[0].num_landmarks)

    def test_a_file_that_is_no_store_is_refused_and_nothing_is_lost(self):
        self.drive(0, 0, 10)
        with open(os.path.join(rospy.get_param("/mapping/output_dir"), "letter.db"), "w") as file:
            file.write("dear aunt")
        answer = rospy.ServiceProxy("/load_map", LoadMap)("letter.db", True)
        self.assertEqual(answer.status.code, Status.INVALID_ARGUMENT)
        self.assertIn("letter.db", answer.status.message)
        self.drive(0, 10, 12)


if __name__ == "__main__":
    rospy.init_node("mapping_store_node_test")
    rostest.rosrun("rovio_sfm", "mapping_store_node_test", MappingStoreTest, sys.argv)
