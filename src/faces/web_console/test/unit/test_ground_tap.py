"""What is heard is read once somebody looks."""

import io
from typing import Any, Callable, Dict, List, Tuple
from unittest import mock

import pytest
import rospy
from nav_msgs.msg import OccupancyGrid

from web_console.board import Board
from web_console.ros_ground import GroundTap


def raw(message: Any) -> rospy.AnyMsg:
    buffer = io.BytesIO()
    message.serialize(buffer)
    return rospy.AnyMsg().deserialize(buffer.getvalue())


def grid(width: int) -> OccupancyGrid:
    message = OccupancyGrid(data=[0] * width)
    message.info.width, message.info.height, message.info.resolution = width, 1, 0.1
    message.info.origin.orientation.w = 1.0
    return message


@pytest.fixture
def tap() -> Tuple[GroundTap, Board, Dict[str, Callable[[Any], None]], List[str]]:
    """A tap, its board, what its topics call, and the names of the pictures that it has made."""
    board, pictures, topics = Board(most_commands=1), [], {}

    def subscribe(topic: str, _kind: Any, callback: Callable[[Any], None], **_settings: Any) -> None:
        topics[topic] = callback

    one = GroundTap(
        board,
        path_topics=(),
        call_soon=lambda function, *arguments: function(*arguments),
        on_change=lambda: None,
        on_picture=lambda name, data: pictures.append(name),
        on_names=lambda names: None,
        on_world=lambda present: None,
    )
    with mock.patch("rospy.Subscriber", subscribe):
        one.start()
    return one, board, topics, pictures


def test_of_many_maps_the_newest_is_drawn_when_somebody_looks(tap) -> None:
    one, board, topics, pictures = tap
    for width in (3, 4, 5):
        topics["map"](raw(grid(width)))
    assert pictures == []
    assert board.snapshot() == ()
    one.look()
    assert pictures == ["map-1.png"]
    ((key, shown),) = board.take_changes()
    assert key == "ground"
    assert '"width_m":0.5' in shown
    one.look()
    assert pictures == ["map-1.png"]


def test_what_cannot_be_read_hides_nothing(tap) -> None:
    one, _, topics, pictures = tap
    topics["amcl_pose"](rospy.AnyMsg().deserialize(b"no pose"))
    topics["map"](raw(grid(3)))
    one.look()
    assert pictures == ["map-1.png"]
