"""The panel of what persons taught."""

import json

import rospy
from roboframenet_msgs.msg import Learned, LearnedItem

from web_console.ros_values import learned_view
from web_console.views import LearnedItemView, LearnedView, as_json

WAY = LearnedItem(
    "make_your_way.going", "make your way", '"make your way" means "go"', "anna", rospy.Time(5), "Make ..."
)


def test_what_was_taught_is_shown_with_the_sentence_that_forgets_it() -> None:
    view = learned_view(Learned(items=[WAY], left_out=2))
    forgets = 'Forget what I taught you about "make your way".'
    item = LearnedItemView("make your way", '"make your way" means "go"', "anna", 5.0, "Make ...", forgets)
    assert view == LearnedView((item,), 2)
    message = json.loads(as_json("learned", view))
    assert message["view"] == "learned" and message["value"]["items"][0]["forgets"] == forgets
