"""Converts standing orders between messages and values."""

import io
import time
import uuid
from dataclasses import replace
from datetime import tzinfo
from typing import Tuple

import rospy
from roboframenet_msgs.msg import Command, CommandPlan, OrderDue, Plan
from roboframenet_msgs.msg import StandingOrder as StandingOrderMessage

from arbitrator.ros_messages import any_from_message, plan_to_message
from arbitrator.standing import STANDING, AnyOrder, At
from standing_orders.order import Firing, StandingOrder
from standing_orders.schedule import next_due_s, schedule_of
from standing_orders.sentences import sentence_of_time, sentence_of_whenever


def order_from_message(message: CommandPlan, now_s: float, zone: tzinfo) -> StandingOrder:
    """Return the order of a command.

    Args:
        message: the command and its plan
        now_s: when it was said, seconds since 1970
        zone: of the clock of the robot
    Raises:
        NoSchedule: its time is not understood, or over; the text is a sentence for the person
        ValueError: the plan is no standing order; the text says why
    """
    part = any_from_message(message.plan)
    if not isinstance(part, STANDING):
        raise ValueError("the plan is no standing order")
    buffer = io.BytesIO()
    message.plan.serialize(buffer)
    text, deed = message.command.text.strip(), part.child.label
    given = StandingOrder(f"order-{uuid.uuid4().hex[:8]}", text, deed, "", buffer.getvalue(), now_s)
    if isinstance(part, At):
        schedule = schedule_of(part.when, now_s, zone)
        due_s = next_due_s(schedule, now_s, zone)
        sentence = sentence_of_time(deed, schedule, due_s or now_s, now_s, zone)
        return replace(given, sentence=sentence, schedule=schedule, next_s=due_s)
    negated = part.condition.is_negated
    return replace(given, sentence=sentence_of_whenever(deed, part.condition.label, is_negated=negated))


def part_of(order: StandingOrder) -> AnyOrder:
    """Return what an order says.

    Raises:
        ValueError: the message was made by another version
    """
    message = Plan()
    try:
        message.deserialize(order.plan)
    except Exception as error:  # boundary: genpy raises what struct and its own code raise
        raise ValueError(f"its plan cannot be read: {error}") from error
    part = any_from_message(message)
    if not isinstance(part, STANDING):
        raise ValueError("its plan is no standing order")
    return part


def due_to_message(firing: Firing) -> OrderDue:
    """Return what is sent when an order is due."""
    order = firing.order
    message = OrderDue(
        command=Command(id=firing.command_id, stamp=rospy.Time.now(), text=order.deed),
        order=order.text.rstrip(" .!"),
        not_done=firing.not_done,
    )
    if not firing.not_done:
        message.plan = plan_to_message(part_of(order).child)
        message.plan.beginning = Plan.WHEN_FREE
    return message


def order_to_message(order: StandingOrder, *, fault: str, is_due: bool) -> StandingOrderMessage:
    """Return what others see of an order.

    Args:
        order: the order
        fault: why nobody can tell whether its condition holds; empty if somebody can
        is_due: whether it waits until nothing else runs
    """
    state, reason = _state(order, fault, is_due)
    is_next = order.next_s is not None and not order.is_suspended and not order.begun
    return StandingOrderMessage(
        id=order.order_id,
        sentence=order.sentence,
        text=order.text,
        given=rospy.Time.from_sec(order.given_s),
        state=state,
        reason=reason,
        next=rospy.Time.from_sec(order.next_s if is_next and order.next_s is not None else 0.0),
        count=order.count,
    )


def _state(order: StandingOrder, fault: str, is_due: bool) -> Tuple[str, str]:
    if order.is_suspended:
        return "suspended", 'You stopped me; say "go on".'
    if order.begun:
        return "runs", ""
    if fault:
        return "blind", fault
    return ("due", "Something else runs.") if is_due else ("waits", "")


def said_s(command: Command) -> float:
    """Return when a command was said, seconds since 1970 on the clock of the machine; ROS time may be another one."""
    return time.time() - max(0.0, (rospy.Time.now() - command.stamp).to_sec())
