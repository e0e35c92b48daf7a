"""Arguments of the states and of the wrapper have the documented names, order and defaults."""

import inspect

import pytest
import rospy

import smach_ros

MESSAGE_FROM = "{0}_cb {0}_cb_args {0}_cb_kwargs {0}_key {0}_slots"
SIGNATURES = {
    smach_ros.SimpleActionState: (
        "action_name action_spec goal goal_key goal_slots goal_cb goal_cb_args goal_cb_kwargs result_key result_slots "
        "result_cb result_cb_args result_cb_kwargs input_keys output_keys outcomes exec_timeout preempt_timeout "
        "server_wait_timeout"
    ),
    smach_ros.ServiceState: (
        f"service_name service_spec request {MESSAGE_FROM.format('request')} {MESSAGE_FROM.format('response')} "
        "input_keys output_keys outcomes server_wait_timeout"
    ),
    smach_ros.ActionServerWrapper: (
        "server_name action_spec wrapped_container succeeded_outcomes aborted_outcomes preempted_outcomes goal_key "
        "feedback_key result_key goal_slots_map feedback_slots_map result_slots_map expand_goal_slots "
        "pack_result_slots"
    ),
    smach_ros.MonitorState: "topic msg_type cond_cb max_checks input_keys output_keys",
    smach_ros.ConditionState: "cond_cb input_keys poll_rate timeout max_checks",
    smach_ros.IntrospectionServer: "server_name state path",
    smach_ros.set_preempt_handler: "sc",
}
DEFAULTS = {
    (smach_ros.SimpleActionState, "exec_timeout"): None,
    (smach_ros.SimpleActionState, "preempt_timeout"): rospy.Duration(60.0),
    (smach_ros.SimpleActionState, "server_wait_timeout"): rospy.Duration(60.0),
    (smach_ros.ActionServerWrapper, "goal_key"): "action_goal",
    (smach_ros.ActionServerWrapper, "feedback_key"): "action_feedback",
    (smach_ros.ActionServerWrapper, "result_key"): "action_result",
    (smach_ros.MonitorState, "max_checks"): -1,
    (smach_ros.ConditionState, "poll_rate"): rospy.Duration(0.05),
    (smach_ros.ConditionState, "max_checks"): 1,
}


@pytest.mark.parametrize("function", SIGNATURES, ids=lambda function: function.__name__)
def test_names_and_order(function):
    assert " ".join(inspect.signature(function).parameters) == SIGNATURES[function]


@pytest.mark.parametrize("function,name", DEFAULTS, ids=lambda part: getattr(part, "__name__", part))
def test_defaults(function, name):
    assert inspect.signature(function).parameters[name].default == DEFAULTS[function, name]
