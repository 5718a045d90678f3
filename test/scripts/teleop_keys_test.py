#!/usr/bin/python3
"""Tests of what teleop makes of keys."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from teleop_keys import HeldKeys


class HeldKeysTest(unittest.TestCase):
    def test_motion_lasts_until_the_key_is_let_go(self):
        keys = HeldKeys()
        self.assertTrue(keys.press("Up", 0.0))
        self.assertEqual(keys.motion(100.0), (1, 0, 0))
        keys.release("Up")
        self.assertEqual(keys.motion(100.0), (0, 0, 0))

    def test_in_a_terminal_it_lasts_as_long_as_the_key_repeats(self):
        keys = HeldKeys(0.6)
        keys.press("A", 0.0)
        self.assertEqual(keys.motion(0.5), (0, 0, 1))
        keys.press("a", 0.5)
        self.assertEqual(keys.motion(1.0), (0, 0, 1))
        self.assertEqual(keys.motion(1.2), (0, 0, 0))

    def test_opposite_keys_cancel_and_others_add(self):
        keys = HeldKeys()
        for key in ("w", "s", "comma", "Right"):
            keys.press(key, 0.0)
        self.assertEqual(keys.motion(0.0), (0, 1, -1))

    def test_two_keys_of_one_motion_are_not_faster(self):
        keys = HeldKeys()
        keys.press("w", 0.0)
        keys.press("Up", 0.0)
        self.assertEqual(keys.motion(0.0), (1, 0, 0))

    def test_other_keys_do_nothing(self):
        keys = HeldKeys()
        self.assertFalse(keys.press("x", 0.0))
        self.assertEqual(keys.motion(0.0), (0, 0, 0))


if __name__ == "__main__":
    unittest.main()
