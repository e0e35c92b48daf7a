"""Stops name the nodes that do not obey, and are repeated for the right time."""

import pytest

from robot_stop.braking import BrakeLimits, Braking, Evidence, LiveGoal, Obedience, StopOrder, VelocitySeen
from robot_stop.sentences import sentence_of
from robot_stop.servers import Server

SECOND_NS = 1_000_000_000
TURN = Server("/turn", takes_frames=True)
FIBONACCI = Server("/fibonacci", takes_frames=False)
STOP = StopOrder("stop", stamp_ns=50 * SECOND_NS)
OLD = LiveGoal(TURN, "old", stamp_ns=49 * SECOND_NS)
OLD_WITH_A_CLOCK_AHEAD = LiveGoal(TURN, "ahead", stamp_ns=99 * SECOND_NS)
NEW = LiveGoal(TURN, "new", stamp_ns=51 * SECOND_NS)


class Robot:
    """A clock, and a stop that the test looks at as time passes."""

    def __init__(self, evidence=Evidence(), *, orders=(STOP,), **limits):
        self.now_s = 1000.0
        self.ros_now_ns = STOP.stamp_ns
        self.braking = Braking(BrakeLimits(**limits), now=lambda: self.now_s)
        for order in orders:
            self.braking.begin(order, evidence)

    def look(self, evidence=Evidence(), *, after_s=0.0):
        self.now_s += after_s
        seen = evidence(self.now_s) if callable(evidence) else evidence
        return self.braking.look(seen, now_ns=self.ros_now_ns)


def driving(*, period_s=None, ago_s=0.0, goals=()):
    """Evidence of a driver at the time of the look."""
    return lambda now_s: Evidence(
        velocities=(VelocitySeen("/teleop", "/cmd_vel", now_s - ago_s, period_s),), goals=goals
    )


def test_robot_that_stands_is_stopped_when_things_have_settled():
    robot = Robot()
    assert robot.look(after_s=0.05).findings == ()
    (finding,) = robot.look(after_s=0.06).findings
    assert (finding.order, finding.obedience.is_complete, finding.is_first, finding.is_last) == (
        STOP,
        True,
        True,
        False,
    )


def test_obeyed_stop_is_repeated_for_a_while_and_answered_once():
    robot = Robot(least_s=1.0)
    assert robot.look(after_s=0.2).repeated == STOP
    look = robot.look(after_s=0.7)
    assert (look.repeated, look.findings) == (STOP, ())
    look = robot.look(after_s=0.2)
    assert (look.repeated, look.findings, robot.braking.is_busy) == (None, (), False)


def test_goal_that_ends_late_delays_the_answer():
    robot = Robot(Evidence(goals=(OLD,)))
    assert robot.look(Evidence(goals=(OLD,)), after_s=0.5).findings == ()
    (finding,) = robot.look(after_s=0.1).findings
    assert finding.obedience.is_complete


@pytest.mark.parametrize("goal", [OLD, OLD_WITH_A_CLOCK_AHEAD])
def test_goal_that_does_not_end_is_named(goal):
    robot = Robot(Evidence(goals=(goal,)))
    assert robot.look(Evidence(goals=(goal,)), after_s=0.9).findings == ()
    (finding,) = robot.look(Evidence(goals=(goal,)), after_s=0.2).findings
    assert finding.obedience.servers == ("/turn",)
    assert finding.obedience.describe() == "/turn has not ended its goal"


def test_goal_that_was_on_its_way_counts_by_its_stamp():
    robot = Robot()
    (finding,) = robot.look(Evidence(goals=(OLD,)), after_s=1.0).findings
    assert finding.obedience.servers == ("/turn",)


def test_driver_is_named_and_zero_velocity_goes_on_up_to_the_limit():
    robot = Robot(confirmation_s=1.0, least_s=1.0, most_s=10.0)
    (first,) = robot.look(driving(), after_s=1.0).findings
    assert (first.obedience.drivers, first.is_first, first.is_last) == ((("/teleop", "/cmd_vel"),), True, False)
    for _ in range(8):
        look = robot.look(driving(), after_s=1.0)
        assert (look.repeated, look.findings) == (STOP, ())
    look = robot.look(driving(), after_s=1.0)
    (last,) = look.findings
    assert (look.repeated, last.is_first, last.is_last, last.obedience) == (None, False, True, first.obedience)
    assert not robot.braking.is_busy


def test_driver_that_gives_up_is_reported():
    robot = Robot()
    assert not robot.look(driving(), after_s=1.0).findings[0].obedience.is_complete
    (finding,) = robot.look(driving(ago_s=0.5), after_s=0.5).findings
    assert (finding.obedience.is_complete, finding.is_first) == (True, False)


def test_velocities_from_before_the_stop_count_until_the_driver_is_quiet():
    robot = Robot()
    assert robot.look(driving(ago_s=0.25), after_s=0.2).findings == ()
    assert robot.look(driving(ago_s=0.31)).findings[0].obedience.is_complete


@pytest.mark.parametrize(
    "period_s, ago_s, is_quiet",
    [(0.05, 0.31, True), (0.4, 0.7, False), (0.4, 0.81, True), (60.0, 0.89, False), (60.0, 0.91, True)],
)
def test_slow_driver_is_quiet_after_two_of_its_periods(period_s, ago_s, is_quiet):
    robot = Robot()
    assert (
        robot.look(driving(period_s=period_s, ago_s=ago_s), after_s=1.0).findings[0].obedience.is_complete == is_quiet
    )


def test_new_command_ends_the_repetition_and_may_drive():
    robot = Robot()
    look = robot.look(driving(goals=(NEW,)), after_s=0.2)
    assert look.repeated is None
    assert [finding.obedience.is_complete for finding in look.findings] == [True]


def test_goal_stamped_at_the_stop_is_neither_old_nor_new():
    robot = Robot()
    look = robot.look(Evidence(goals=(LiveGoal(TURN, "race", STOP.stamp_ns + 1_000_000),)), after_s=0.2)
    assert look.repeated == STOP
    assert look.findings[0].obedience.is_complete


def test_goal_of_a_clock_that_was_set_back_is_new_and_one_from_before_is_not():
    robot = Robot(Evidence(goals=(OLD,)))
    robot.ros_now_ns = 10 * SECOND_NS
    new = LiveGoal(TURN, "new", stamp_ns=10 * SECOND_NS)
    late = LiveGoal(TURN, "late", stamp_ns=STOP.stamp_ns - 1)
    look = robot.look(Evidence(goals=(OLD, late)), after_s=1.0)
    assert look.repeated == STOP and look.findings[0].obedience.servers == ("/turn",)
    # The time may have reached that of the stop again.
    robot.ros_now_ns = STOP.stamp_ns
    look = robot.look(driving(goals=(new,)), after_s=0.1)
    assert look.repeated is None and [finding.obedience.is_complete for finding in look.findings] == [True]


def test_early_stamp_counts_as_old_while_the_clock_was_not_set_back():
    robot = Robot()
    look = robot.look(Evidence(goals=(LiveGoal(TURN, "unknown", stamp_ns=10 * SECOND_NS),)), after_s=1.0)
    assert look.repeated == STOP and not look.findings[0].obedience.is_complete


def test_order_for_frames_leaves_ordinary_clients_and_an_exception_alone():
    own = Server("/stopping", takes_frames=True)
    order = StopOrder("stop", STOP.stamp_ns, is_for_frames_only=True, except_server=own.name)
    goals = Evidence(goals=(LiveGoal(own, "a", 1), LiveGoal(FIBONACCI, "b", 1)))
    robot = Robot(goals, orders=(order,))
    assert robot.look(goals, after_s=1.0).findings[0].obedience.is_complete
    assert order.covers(TURN) and not order.covers(own) and not order.covers(FIBONACCI)
    assert STOP.covers(FIBONACCI)


def test_each_stop_of_a_flood_is_answered_and_only_the_newest_is_repeated():
    orders = [StopOrder(str(index), STOP.stamp_ns + index) for index in range(25)]
    robot = Robot(orders=orders)
    look = robot.look(after_s=0.2)
    assert [finding.order for finding in look.findings] == orders
    assert look.repeated == orders[-1]
    assert robot.look(driving(), after_s=0.2).findings[0].order == orders[-1]


def test_released_stop_is_dropped():
    robot = Robot()
    robot.braking.release("stop")
    assert not robot.braking.is_busy


def test_unread_graph_is_reported():
    robot = Robot()
    blind = Evidence(is_complete=False)
    assert robot.look(blind, after_s=0.5).findings == ()
    (finding,) = robot.look(blind, after_s=0.5).findings
    assert finding.obedience.describe() == "the graph of nodes could not be read"


def test_process_that_was_suspended_waits_longer():
    robot = Robot(orders=())
    robot.braking.begin(STOP, Evidence(), is_just_awake=True)
    assert robot.look(after_s=0.4).findings == ()
    assert len(robot.look(after_s=0.2).findings) == 1


def test_sentences():
    robot = Robot()
    (stopped,) = robot.look(after_s=0.2).findings
    assert sentence_of(stopped, server_count=1, limit_s=10.0) == (
        "Stopped: zero velocity, and no goal is left on 1 action server."
    )
    robot = Robot()
    (finding,) = robot.look(driving(goals=(OLD, LiveGoal(FIBONACCI, "f", 1))), after_s=1.0).findings
    assert finding.obedience.names == ("/fibonacci", "/teleop", "/turn")
    assert sentence_of(finding, server_count=2, limit_s=10.0) == (
        "The robot may still move: /teleop publishes velocities on /cmd_vel and /fibonacci and /turn have not ended "
        "their goals. Zero velocity is repeated for up to 10 s."
    )
    assert Obedience().describe() == ""
