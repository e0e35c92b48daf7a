"""ActionServerWrapper: offers a container as an action."""

import traceback
from typing import Any, Dict, Iterable, List, Mapping, Optional

import actionlib
import rospy

import smach


class ActionServerWrapper:
    """Action server that runs a container for each goal and ends the goal as the container ends.

    The goal is put where the container, and the states in it, find it as userdata; the result is taken from there.
    It is no state: it cannot be put into a container.

    Actions:
        server_name (action_spec): server

    Args:
        server_name: name of the action
        action_spec: its type, for example MoveBaseAction
        wrapped_container: the container
        succeeded_outcomes: its outcomes that end the goal as succeeded
        aborted_outcomes: its outcomes that end the goal as aborted, as do those that are named nowhere
        preempted_outcomes: its outcomes that end the goal as preempted
        goal_key: userdata key of the goal
        feedback_key: userdata key from which the feedback is published at each transition, when it has a value
        result_key: userdata key of the result; an empty one is there at the start
        goal_slots_map: from fields of the goal to userdata keys that get their values
        feedback_slots_map: from fields of the feedback to the userdata keys that hold their values
        result_slots_map: from fields of the result to the userdata keys that hold their values
        expand_goal_slots: put every field of the goal into the userdata, under its name unless the map has another
        pack_result_slots: take every field of the result from the userdata, under its name unless the map has another

    Attributes:
        userdata: values that each goal starts with, beside its own

    Raises:
        InvalidStateError: an outcome is in two of the lists, or a map names a field that the message does not have
    """

    def __init__(
        self,
        server_name: str,
        action_spec: type,
        wrapped_container: smach.State,
        succeeded_outcomes: Iterable[str] = (),
        aborted_outcomes: Iterable[str] = (),
        preempted_outcomes: Iterable[str] = (),
        goal_key: str = "action_goal",
        feedback_key: str = "action_feedback",
        result_key: str = "action_result",
        goal_slots_map: Optional[Mapping[str, str]] = None,
        feedback_slots_map: Optional[Mapping[str, str]] = None,
        result_slots_map: Optional[Mapping[str, str]] = None,
        expand_goal_slots: bool = False,
        pack_result_slots: bool = False,
    ) -> None:
        self.wrapped_container = wrapped_container
        self.userdata = smach.UserData()
        self._server_name = server_name
        self._action_spec = action_spec
        self._end_of = _ends(succeeded_outcomes, aborted_outcomes, preempted_outcomes)
        unknown = sorted(set(self._end_of).difference(wrapped_container.get_registered_outcomes()))
        if unknown:
            rospy.logwarn("Action server '%s': the container has no outcomes %s", server_name, unknown)
        self._goal_key, self._feedback_key, self._result_key = goal_key, feedback_key, result_key
        action = action_spec()
        goal_class = type(action.action_goal.goal)
        self._feedback_class = type(action.action_feedback.feedback)
        self._result_class = type(action.action_result.result)
        self._goal_slots = _slots(goal_class, goal_slots_map, expand_goal_slots)
        self._feedback_slots = _slots(self._feedback_class, feedback_slots_map, False)
        self._result_slots = _slots(self._result_class, result_slots_map, pack_result_slots)
        self._server: Optional[actionlib.SimpleActionServer] = None
        if isinstance(wrapped_container, smach.Container):
            wrapped_container.register_transition_cb(self.transition_cb)
            wrapped_container.register_termination_cb(self.termination_cb)

    def run_server(self) -> None:
        """Start the server and return; goals run in its own thread."""
        if self._server is not None:
            return
        self._server = actionlib.SimpleActionServer(self._server_name, self._action_spec, self.execute_cb, False)
        self._server.register_preempt_callback(self.preempt_cb)
        self._server.start()

    def execute_cb(self, goal: Any) -> None:
        """Run the container for one goal."""
        container = self.wrapped_container
        # A request that arrived just after the last goal had ended is not meant for this one.
        container.recall_preempt()
        if self._server.is_preempt_requested():
            container.request_preempt()
        userdata = smach.UserData()
        userdata.update(self.userdata)
        try:
            self._load(goal, userdata)
            outcome = container.execute(userdata)
            result = self._result(userdata)
        except Exception as error:  # boundary: whatever the container raises must end the goal
            rospy.logerr("The container of action server '%s' raised:\n%s", self._server_name, traceback.format_exc())
            self._server.set_aborted(text=f"{type(error).__name__}: {error}")
            return
        rospy.loginfo("Action server '%s': the container ended with '%s'", self._server_name, outcome)
        end = self._end_of.get(outcome)
        if end is None:
            rospy.logerr(
                "Action server '%s': the outcome '%s' belongs to no end of the goal, which is aborted",
                self._server_name,
                outcome,
            )
        set_end = {"succeeded": self._server.set_succeeded, "preempted": self._server.set_preempted}.get(
            end, self._server.set_aborted
        )
        set_end(result, f"outcome '{outcome}'")

    def preempt_cb(self) -> None:
        """Ask the container to stop."""
        self.wrapped_container.request_preempt()

    def transition_cb(self, userdata: smach.UserData, active_states: List[str]) -> None:
        """Publish the feedback that the last state left in the userdata."""
        self.publish_feedback(userdata)

    def termination_cb(
        self, userdata: smach.UserData, terminal_states: List[str], container_outcome: Optional[str]
    ) -> None:
        """Publish the feedback that the last state left in the userdata."""
        self.publish_feedback(userdata)

    def publish_feedback(self, userdata: smach.UserData) -> None:
        """Publish the feedback that the userdata holds, if it holds any and a goal runs."""
        slots = {slot: key for slot, key in self._feedback_slots.items() if key in userdata}
        if self._server is None or not self._server.is_active() or not (slots or self._feedback_key in userdata):
            return
        self._server.publish_feedback(_message(self._feedback_class, self._feedback_key, slots, userdata))

    def _userdata_of_container(self) -> smach.UserData:
        return getattr(self.wrapped_container, "userdata", smach.UserData())

    def _load(self, goal: Any, userdata: smach.UserData) -> None:
        """Put the goal where the container copies its input keys from, and where its states read."""
        for target in (userdata, self._userdata_of_container()):
            target[self._goal_key] = goal
            target[self._result_key] = self._result_class()
            for slot, key in self._goal_slots.items():
                target[key] = getattr(goal, slot)

    def _result(self, userdata: smach.UserData) -> Any:
        """Result in the output keys of the container, or else in its own userdata."""
        found = smach.UserData()
        found.update(self._userdata_of_container())
        written = self.wrapped_container.get_registered_output_keys()
        for key in userdata.keys():
            if key in written:
                found[key] = userdata[key]
        missing = [key for key in self._result_slots.values() if key not in found]
        if missing:
            rospy.logwarn("Action server '%s': nothing in the userdata for the result: %s", self._server_name, missing)
        slots = {slot: key for slot, key in self._result_slots.items() if key in found}
        return _message(self._result_class, self._result_key, slots, found)


def _ends(succeeded: Iterable[str], aborted: Iterable[str], preempted: Iterable[str]) -> Dict[str, str]:
    """How a goal ends, by outcome; InvalidStateError when that is not clear."""
    end_of: Dict[str, str] = {}
    for end, outcomes in (("succeeded", succeeded), ("aborted", aborted), ("preempted", preempted)):
        for outcome in outcomes:
            if end_of.setdefault(outcome, end) != end:
                raise smach.InvalidStateError(
                    f"The outcome '{outcome}' cannot end a goal as {end_of[outcome]} and as {end}."
                )
    return end_of


def _slots(message_class: type, given: Optional[Mapping[str, str]], is_every: bool) -> Dict[str, str]:
    """Userdata keys by field; InvalidStateError when the message has no such field."""
    unknown = [slot for slot in given or {} if slot not in message_class.__slots__]
    if unknown:
        raise smach.InvalidStateError(
            f"{message_class._type} has no fields {unknown}; its fields are: {list(message_class.__slots__)}"
        )
    slots = {slot: slot for slot in message_class.__slots__} if is_every else {}
    slots.update(given or {})
    return slots


def _message(message_class: type, key: str, slots: Mapping[str, str], userdata: smach.UserData) -> Any:
    """The message under a key, with the fields that lie under keys of their own."""
    message = userdata[key] if key in userdata else message_class()
    if not isinstance(message, message_class):
        raise smach.InvalidUserCodeError(
            f"userdata key '{key}' has to hold a {message_class._type}, not a {type(message).__name__}"
        )
    for slot, slot_key in slots.items():
        setattr(message, slot, userdata[slot_key])
    return message
