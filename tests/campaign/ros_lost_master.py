"""One trial with a lost master; a process of its own, because rospy knows one master."""

import json
import os
import signal
import subprocess
import sys
from typing import Any, Dict

from roboframenet_testing import comes_true

from .ros_robot import running_robot

_TIMEOUT_S = 400.0


def in_own_process(how: str) -> Dict[str, Any]:
    """Make the trial in a process of its own.

    Args:
        how: "kill" or "hang"
    """
    command = [sys.executable, "-m", "campaign.ros_lost_master", how]
    done = subprocess.run(command, stdout=subprocess.PIPE, timeout=_TIMEOUT_S, check=True)
    found: Dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


def lose(how: str) -> Dict[str, Any]:
    """Drive, take the master away, stop, and say something."""
    with running_robot(has_master_apart=True) as robot:
        robot.wait_until_ready()
        robot.drive()
        robot.forget()
        assert robot.launched.master is not None
        pid = robot.launched.master.pid
        os.kill(pid, signal.SIGKILL if how == "kill" else signal.SIGSTOP)
        try:
            said_s = robot.say("Stop.")
            is_zero = comes_true(lambda: bool(robot.zero_s), 10.0)
            is_standing = robot.stand()
            texts = ["Stop.", "Ping.", "Turn left 20 degrees."]
            for text in texts[1:]:
                robot.reply_to(text, 40.0)
            return {
                "how": how,
                "zero_s": robot.zero_s[0] - said_s if is_zero else None,
                "moving": int(not is_standing),
                "unanswered": sum(not robot.replies(text=text) for text in texts),
                "not_answered": [text for text in texts if not robot.replies(text=text)],
            }
        finally:
            if how == "hang":
                os.kill(pid, signal.SIGCONT)


if __name__ == "__main__":
    print(json.dumps(lose(sys.argv[1])), flush=True)
    # rospy may wait for its master at the end of the process.
    os._exit(0)
