"""The panel of the standing orders."""

import json

import rospy
from roboframenet_msgs.msg import StandingOrder, StandingOrders

from web_console.ros_values import orders_view
from web_console.views import OrdersView, OrderView, as_json


def test_orders_show_when_they_are_due_and_their_state():
    bell = StandingOrder(sentence="I will go to the door whenever the bell rings.", state="waits", count=2)
    noon = StandingOrder(sentence="I will say hello at noon.", state="suspended", reason="You stopped me.")
    noon.next = rospy.Time(1_795_348_800)
    assert orders_view(StandingOrders(orders=[bell, noon])) == OrdersView(
        (
            OrderView("I will go to the door whenever the bell rings.", "waits", count=2),
            OrderView("I will say hello at noon.", "suspended", "You stopped me.", 1_795_348_800.0),
        )
    )


def test_page_gets_the_orders_as_json():
    message = json.loads(as_json("orders", OrdersView((OrderView("I will wave.", "blind", "no server"),))))
    order = {"sentence": "I will wave.", "state": "blind", "reason": "no server", "next_s": 0.0, "count": 0}
    assert message == {"view": "orders", "value": {"orders": [order]}}
