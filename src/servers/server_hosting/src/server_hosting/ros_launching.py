"""Starts and ends the processes of a server through roslaunch. For the main thread only."""

import os
from typing import List, Tuple

import roslaunch
import rospy

from server_hosting.manifest import Manifest


class LaunchError(RuntimeError):
    """A server could not be started; the message says why."""


class Launched:
    """The processes of one server."""

    def __init__(self, manifest: Manifest) -> None:
        """Start them; they may still be starting up when this returns.

        Raises:
            LaunchError: no such package, file or program, or roslaunch cannot start it
        """
        files: List[Tuple[str, List[str]]] = []
        texts: List[str] = []
        try:
            if manifest.launch is not None:
                files.append(
                    (_path_of(manifest), [f"{name}:={value}" for name, value in manifest.launch.arguments.items()])
                )
            else:
                texts.append(manifest.program.as_launch_xml())
            self._parent = roslaunch.parent.ROSLaunchParent(
                rospy.get_param("/run_id"), files, roslaunch_strs=texts, show_summary=False, is_core=False
            )
            self._parent.start()
        except (roslaunch.RLException, OSError, ValueError, KeyError) as error:
            raise LaunchError(f"{manifest.server} cannot be started: {error}") from error
        if not self._parent.pm.get_active_names():
            self.end()
            raise LaunchError(f"{manifest.server} cannot be started: no process started")

    def is_running(self) -> bool:
        """Whether a process is running, or will be restarted."""
        monitor = self._parent.pm
        if monitor is None or monitor.is_shutdown:
            return False
        # The processes are asked directly: the monitor notices a death some tenths of a second later.
        return any(process.respawn or process.is_alive() for process in tuple(monitor.procs))

    def end(self) -> None:
        """End the processes; returns when they have ended, after some seconds at most."""
        self._parent.shutdown()


def _path_of(manifest: Manifest) -> str:
    launch = manifest.launch
    if launch.package:
        found = roslaunch.rlutil.resolve_launch_arguments([launch.package, launch.file])
        return str(found[0])
    path = os.path.join(os.path.dirname(os.path.abspath(manifest.path)), launch.file)
    if not os.path.isfile(path):
        raise OSError(f"there is no file {path}")
    return path


__all__ = ["LaunchError", "Launched"]
