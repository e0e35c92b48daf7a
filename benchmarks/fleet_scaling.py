#!/usr/bin/env python3
"""What grows with the number of robots: sizes of the real messages, times to make them, and messages a second.

    benchmarks/fleet_scaling.py [--parse-ms 7] [--servers 11] [--commands-per-hour 60]

It needs no ROS master. The sizes are those of serialised messages with the names and profiles that the servers of a
simulated Turtlebot register; times are of one core. The other columns follow by multiplication.
"""

import argparse
import io
import time
from typing import Sequence, Tuple

from roboframenet_msgs.msg import (
    Fleet,
    FleetMember,
    FleetRobot,
    FleetService,
    FrameCallback,
    FrameServers,
    HeededElement,
    ServerProfile,
)

SIZES = (1, 10, 100, 1000, 10_000)
#: Signs of life a second: of a robot, and of the service, which goes to each robot. The list goes out on changes only.
SIGNS_PER_S = 2.0
SERVICE_SIGNS_PER_S = 1.0
#: Stage events and messages from one stage to the next, of a command with one clause.
MESSAGES_PER_COMMAND = 16


def servers_of(robot: str, count: int) -> Sequence[FrameCallback]:
    """Return what a robot registers."""
    profile = ServerProfile(
        robot=robot, occupies=["base"], heeds=[HeededElement(name="Manner", values=["slow", "quick", "careful"])]
    )
    return [
        FrameCallback(
            frame_name=f"moving_forward_{number}",
            callback_topic=f"/{robot}/moving_forward_{number}",
            is_alive=True,
            profile=profile,
        )
        for number in range(count)
    ]


def size_and_time(message: object) -> Tuple[int, float]:
    """Return the bytes of a message, and the seconds of a core that it takes to make them."""
    buffer = io.BytesIO()
    begin_s = time.process_time()
    message.serialize(buffer)  # type: ignore[attr-defined]
    return buffer.tell(), time.process_time() - begin_s


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--parse-ms", type=float, default=7.0, help="time of one parse")
    parser.add_argument("--servers", type=int, default=11, help="servers of a robot")
    parser.add_argument("--commands-per-hour", type=float, default=60.0, help="for each robot")
    arguments = parser.parse_args()
    print("robots registrations snapshot_kB snapshot_ms list_kB list_ms", end=" ")
    print("list_to_all_MB signs_per_s signs_kB_per_s commands_per_s parser_share")
    for count in SIZES:
        names = [f"robot_{number}" for number in range(count)]
        callbacks = [one for name in names for one in servers_of(name, arguments.servers)]
        snapshot, snapshot_s = size_and_time(FrameServers(registrar_id="0" * 32, callbacks=callbacks))
        fleet, fleet_s = size_and_time(Fleet(robots=[FleetRobot(name=name) for name in names]))
        sign, _ = size_and_time(FleetMember(name=names[-1], on_loss="finish"))
        service_sign, _ = size_and_time(FleetService(is_up=True))
        signs_bytes = SIGNS_PER_S * sign + SERVICE_SIGNS_PER_S * service_sign
        commands_per_s = count * arguments.commands_per_hour / 3600.0
        print(
            count,
            len(callbacks),
            f"{snapshot / 1e3:.1f}",
            f"{1e3 * snapshot_s:.2f}",
            f"{fleet / 1e3:.1f}",
            f"{1e3 * fleet_s:.2f}",
            f"{count * fleet / 1e6:.4g}",
            f"{SIGNS_PER_S * count:.0f}",
            f"{count * signs_bytes / 1e3:.1f}",
            f"{commands_per_s:.2f}",
            f"{commands_per_s * arguments.parse_ms / 1e3:.3f}",
        )
    print(f"messages of one command, whatever the number of robots: {MESSAGES_PER_COMMAND}")


if __name__ == "__main__":
    main()
