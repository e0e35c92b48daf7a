"""A clock that stands with the simulation."""

from roboframenet_ros.pausable_clock import LONGEST_PAUSE_S, LONGEST_TICK_S, PausableClock


class Times:
    """Both times, set by hand."""

    def __init__(self) -> None:
        self.now_s = 100.0
        self.ros_ns = 0


def make(is_simulated: bool = True):
    times = Times()
    clock = PausableClock(ros_time_ns=lambda: times.ros_ns, is_simulated=is_simulated, now=lambda: times.now_s)
    return clock, times


def test_running_simulation_is_the_monotonic_clock_however_slow_it_is() -> None:
    clock, times = make()
    for tick in range(1, 50):
        times.now_s += LONGEST_TICK_S
        times.ros_ns += tick
        assert clock.now_s() == times.now_s


def test_clock_stands_while_the_simulation_is_paused_and_goes_on_afterwards() -> None:
    clock, times = make()
    for _ in range(100):
        times.now_s += 0.1
        assert clock.now_s() <= 100.0 + LONGEST_TICK_S + 1e-9
    times.ros_ns += 1
    resumed_s = clock.now_s()
    assert abs(resumed_s - (100.0 + LONGEST_TICK_S)) < 1e-9
    times.now_s += 0.2
    assert abs(clock.now_s() - resumed_s - 0.2) < 1e-9


def test_clock_never_goes_back() -> None:
    clock, times = make()
    last_s = clock.now_s()
    for step in range(200):
        times.now_s += 0.07
        if step % 60 < 20:
            times.ros_ns += 1
        now_s = clock.now_s()
        assert now_s >= last_s - 1e-9
        last_s = now_s


def test_simulator_that_has_died_does_not_stop_the_clock_for_ever() -> None:
    clock, times = make()
    times.now_s += 2.0 * LONGEST_PAUSE_S
    assert clock.now_s() - 100.0 >= LONGEST_PAUSE_S


def test_time_of_the_machine_counts_while_somebody_looks() -> None:
    clock, times = make(is_simulated=False)
    for _ in range(50):
        times.now_s += LONGEST_TICK_S
        assert clock.now_s() == times.now_s


def test_time_in_which_the_process_did_not_run_does_not_count() -> None:
    clock, times = make(is_simulated=False)
    times.now_s += 60.0
    assert clock.now_s() == 100.0 + LONGEST_TICK_S
    times.now_s += 0.2
    assert abs(clock.now_s() - (100.2 + LONGEST_TICK_S)) < 1e-9
