"""Shared by the tests of the whole graph."""

import os
from typing import Iterable, Set

import rospy
from roboframenet_msgs.msg import FrameCatalogue, Lexicon

from roboframenet_testing import comes_true


def can_do(frames: Iterable[str], *, unit_files: Iterable[str] = (), timeout_s: float = 60.0) -> bool:
    """Wait until a living server has registered for each frame; a server may start later than the pipeline.

    Args:
        frames: names of frames
        unit_files: names, without folders, of lexical unit files that must have been read
        timeout_s: how long to wait
    Returns:
        whether all of it is there
    """
    done: Set[str] = set()
    known: Set[str] = set()

    def on_catalogue(catalogue: FrameCatalogue) -> None:
        done.update(callback.frame_name for callback in catalogue.callbacks if callback.is_alive)

    def on_lexicon(lexicon: Lexicon) -> None:
        known.update(os.path.basename(file.path) for file in lexicon.files)

    subscribers = [
        rospy.Subscriber("frame_catalogue", FrameCatalogue, on_catalogue),
        rospy.Subscriber("lexicon", Lexicon, on_lexicon),
    ]
    try:
        return comes_true(lambda: done.issuperset(frames) and known.issuperset(unit_files), timeout_s)
    finally:
        for subscriber in subscribers:
            subscriber.unregister()
