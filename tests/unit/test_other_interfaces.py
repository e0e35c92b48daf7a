"""Messages of other packages that the underlay stands in for: each has the MD5 sum of Noetic's."""

import importlib

import pytest

CHECKSUMS = [
    ("control_msgs.msg", "GripperCommandAction", "950b2a6ebe831f5d4f4ceaba3d8be01e"),
    ("control_msgs.msg", "FollowJointTrajectoryAction", "bc4f9b743838566551c0390c65f1a248"),
    ("sound_play.msg", "SoundRequest", "d098ce4a040686259137ece23a625167"),
    ("play_motion_msgs.msg", "PlayMotionAction", "b18530db1ae596c4c0ca2ede0819fc9e"),
    ("kobuki_msgs.msg", "AutoDockingAction", "44be114f3afc06365a090db0a5e982b5"),
    ("vision_msgs.msg", "Detection2DArray", "402071f61477de256df9f1aa45e6e4c8"),
    ("vision_msgs.msg", "Detection3DArray", "05c51d9aea1fb4cfdc8effb94f197b6f"),
    ("ar_track_alvar_msgs.msg", "AlvarMarkers", "943fe17bfb0b4ea7890368d0b25ad0ad"),
    ("turtlesim.msg", "Pose", "863b248d5016ca62ea2e895ae5265cf9"),
]


@pytest.mark.parametrize("module, name, checksum", CHECKSUMS)
def test_sum(module: str, name: str, checksum: str) -> None:
    assert getattr(importlib.import_module(module), name)._md5sum == checksum
