"""Which motion the keys that are held down ask for; no ROS, no window."""

# Key → (forward, to the left, turn to the left), as shares of the greatest speeds.
MOTIONS = {
    "Up": (1, 0, 0), "w": (1, 0, 0), "Down": (-1, 0, 0), "s": (-1, 0, 0),
    "comma": (0, 1, 0), "q": (0, 1, 0), "period": (0, -1, 0), "e": (0, -1, 0),
    "Left": (0, 0, 1), "a": (0, 0, 1), "Right": (0, 0, -1), "d": (0, 0, -1)}
HELP = ("arrows or w s: forward, back\n"
        "arrows or a d: turn\n"
        ", . or q e: sideways\n"
        "stops when no key is held")


class HeldKeys:
    """The keys that are down. Where nobody tells of releases (a terminal), a key is held for
    `hold_s` after it came last. Times are seconds of any steady clock."""

    def __init__(self, hold_s=float("inf")):
        self.hold_s = hold_s
        self.last = {}  # key: when it came last

    def press(self, key, now_s):
        """Whether the key moves the robot."""
        if len(key) == 1:
            key = key.lower()
        if key in MOTIONS:
            self.last[key] = now_s
        return key in MOTIONS

    def release(self, key):
        self.last.pop(key.lower() if len(key) == 1 else key, None)

    def release_all(self):
        self.last.clear()

    def motion(self, now_s):
        """(forward, left, turn), each -1, 0 or 1; opposite keys cancel."""
        self.last = {key: at for key, at in self.last.items() if now_s - at < self.hold_s}
        held = {MOTIONS[key] for key in self.last}
        return tuple(max(-1, min(1, sum(motion[i] for motion in held))) for i in range(3))
