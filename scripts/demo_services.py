"""The services of mapping and place_recognition, called as a user would: what was merged is taken
apart and merged again."""

import yaml

from demo_graph import run


def call(service, **request):
    """The reply of a service, asked by rosservice."""
    return yaml.safe_load(run("rosservice", "call", service, yaml.safe_dump(request, default_flow_style=True)))


def count_maps(sessions):
    """How many maps hold sessions with frames."""
    return len({session["map"] for session in sessions if session["num_keyframes"] > 0})


def list_sessions():
    return call("/list_sessions")["sessions"]


def take_apart_and_merge():
    """{what was asked: whether it was so}"""
    before = list_sessions()
    root, other = sorted(session["session"] for session in before if session["num_keyframes"] > 0)[:2]
    undone = call("/unmerge_session", session=other)
    apart = list_sessions()
    found = call("/find_overlaps", session_a=root, session_b=other, publish=False)
    merged = call("/merge_sessions", session_a=root, session_b=other, force=False, by_hand=False)
    after = list_sessions()
    return {
        f"list_sessions: {len(before)} sessions in one map": count_maps(before) == 1,
        f"unmerge_session: {len(undone['undone'])} merges undone, {count_maps(apart)} maps":
            len(undone["undone"]) > 0 and count_maps(apart) == 2,
        f"find_overlaps: {len(found['matches'])} overlaps": len(found["matches"]) > 0,
        f"merge_sessions: {merged['status']['message'] or merged['report']['reason']}; "
        f"{count_maps(after)} map": count_maps(after) == 1}
