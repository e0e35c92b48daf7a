"""Applies and restores settings of nodes through dynamic_reconfigure."""

import threading
from dataclasses import replace
from typing import Callable, Dict, List, Sequence, Set, Tuple, TypeVar

import rospy
from dynamic_reconfigure.msg import BoolParameter, Config, DoubleParameter, IntParameter, StrParameter
from dynamic_reconfigure.srv import Reconfigure
from rospy.impl.paramserver import get_param_server_cache

from executor.driver_settings import (
    HeldSetting,
    Setting,
    SettingsError,
    Value,
    check_needs,
    differs,
    fit_value,
    from_record,
    read_needs,
    to_record,
    unknown_setting,
)
from roboframenet_ros.deadline import NoAnswer, within
from roboframenet_ros.ros_kept_value import KeptValue

_RETRY_S = 1.0
_LONGEST_RETRY_S = 16.0
Answer = TypeVar("Answer")


def _ask_within(timeout_s: float, ask: Callable[[], Answer], what: str) -> Answer:
    """Ask a service or the master with a deadline; rospy has none for them.

    Raises:
        SettingsError: no answer in time, or the asking failed
    """
    try:
        return within(timeout_s, ask, name="ask_settings")
    except NoAnswer as error:
        raise SettingsError(f"{what}: {error}") from None
    except Exception as error:  # boundary: services and the master fail in many ways
        raise SettingsError(f"{what}: {error}") from error


def _values(config: Config) -> Dict[str, Value]:
    parameters = list(config.bools) + list(config.ints) + list(config.strs) + list(config.doubles)
    return {parameter.name: parameter.value for parameter in parameters}


def _config(values: Dict[str, Value]) -> Config:
    config = Config()
    for name, value in values.items():
        if isinstance(value, bool):
            config.bools.append(BoolParameter(name=name, value=value))
        elif isinstance(value, int):
            config.ints.append(IntParameter(name=name, value=value))
        elif isinstance(value, float):
            config.doubles.append(DoubleParameter(name=name, value=value))
        else:
            config.strs.append(StrParameter(name=name, value=value))
    return config


class DriverSettings:
    """Applies the settings that servers need, and restores the former values.

    The parameter ``<server>/required_settings`` holds what a server needs (`read_needs`). The former values are kept in
    a file, so that an executor that was killed restores them when it is restarted. The values of a node
    that is not running are restored when it is back.
    """

    def __init__(self, *, timeout_s: float, parameter: str = "~applied_settings") -> None:
        """Start with nothing applied.

        Args:
            timeout_s: how long a node, or the master, may take to answer
            parameter: holds the name of the file
        """
        self._timeout_s = timeout_s
        self._record = KeptValue(parameter)
        self._lock = threading.Lock()
        self._held: Dict[Tuple[str, str], HeldSetting] = {}
        self._asked: Set[str] = set()
        self._left_over: List[Setting] = []
        self._is_closing = threading.Event()
        self._thread = threading.Thread(target=self._restore_left_over, name="driver_settings", daemon=True)

    def start(self) -> None:
        """Start to restore what the previous run left."""
        try:
            with self._lock:
                self._left_over = list(from_record(self._record.load()))
        except ValueError as error:
            rospy.logwarn("could not restore the settings of the previous run: %s", error)
        self._thread.start()

    def close(self, *, timeout_s: float) -> None:
        """End the thread, and remove an empty record."""
        self._is_closing.set()
        self._thread.join(timeout_s)
        self._record.close()

    def apply(self, server: str, *, owner: str, stated: Sequence[Setting] = ()) -> None:
        """Apply what a server needs.

        Args:
            server: its name
            owner: the step, for `restore`
            stated: what the server stated when it registered, besides its parameter

        Raises:
            SettingsError: not possible; nothing stays applied
        """
        needs = [
            replace(setting, node=rospy.resolve_name(setting.node))
            for setting in (*stated, *read_needs(self._find_needs(server), server=server))
        ]
        if not needs:
            return
        with self._lock:
            try:
                check_needs(needs, self._held)
                for node in sorted({setting.node for setting in needs}):
                    self._apply_to_node(node, [setting for setting in needs if setting.node == node], owner)
            except SettingsError:
                self._restore(owner)
                raise

    def prepare(self, server: str) -> None:
        """Ask the master now what a server needs, and not when it gets a goal.

        Raises:
            SettingsError: the master does not answer
        """
        self._find_needs(server)

    def _find_needs(self, server: str) -> object:
        """Return what the parameter of a server holds, None for nothing.

        The master is asked once; from then on it tells this node of changes.
        """
        name = rospy.resolve_name(f"{server}/required_settings")
        if name not in self._asked:
            _ask_within(self._timeout_s, lambda: rospy.get_param_cached(name, None), f"settings of {server}")
            self._asked.add(name)
        try:
            # get_param_cached() would ask the master again about a parameter that it does not have.
            return get_param_server_cache().get(name)
        except KeyError:
            return None

    def restore(self, *, owner: str) -> None:
        """Restore the former values of settings that no step needs any more; never raises."""
        with self._lock:
            self._restore(owner)

    def _apply_to_node(self, node: str, needs: Sequence[Setting], owner: str) -> None:
        current = self._reconfigure(node, {})
        wanted: Dict[str, Value] = {}
        waiting = {setting.place: setting for setting in self._left_over}
        for setting in needs:
            if setting.name not in current:
                raise unknown_setting(setting, list(current))
            wanted[setting.name] = fit_value(setting, current[setting.name])
            known = self._held.get(setting.place)
            # A value that is still to be restored is the one from before the first change.
            former = waiting[setting.place].value if setting.place in waiting else current[setting.name]
            self._held[setting.place] = (
                HeldSetting(setting=setting, former=former, owners=(owner,))
                if (known is None)
                else replace(known, owners=known.owners + (owner,))
            )
        self._left_over = [setting for setting in self._left_over if setting.place not in self._held]
        # Saved before the change: a kill in between restores a value that has not changed.
        self._save()
        after = self._reconfigure(node, wanted)
        for name, value in wanted.items():
            if differs(value, after.get(name)):
                raise SettingsError(f"{node} took {after.get(name)!r} for {name}, not {value!r}")
        rospy.loginfo("settings of %s for %s: %s", node, owner, wanted)

    def _restore(self, owner: str) -> None:
        nodes: Set[str] = set()
        for place, entry in list(self._held.items()):
            if owner not in entry.owners:
                continue
            owners = tuple(other for other in entry.owners if other != owner)
            if owners:
                self._held[place] = replace(entry, owners=owners)
                continue
            del self._held[place]
            self._left_over.append(replace(entry.setting, value=entry.former))
            nodes.add(entry.setting.node)
        for node in sorted(nodes):
            self._restore_node(node)

    def _restore_node(self, node: str) -> bool:
        """Restore the former values of a node; they are kept when it is not running."""
        mine = [setting for setting in self._left_over if setting.node == node]
        try:
            self._reconfigure(node, {setting.name: setting.value for setting in mine})
        except SettingsError as error:
            rospy.logwarn("settings cannot be restored yet: %s", error)
            return False
        rospy.loginfo("settings of %s are restored: %s", node, {setting.name: setting.value for setting in mine})
        self._left_over = [setting for setting in self._left_over if setting.node != node]
        self._save()
        return True

    def _restore_left_over(self) -> None:
        # A node that hangs holds up the lock: growing pauses let steps take it.
        wait_s = _RETRY_S
        while not self._is_closing.is_set():
            with self._lock:
                nodes = sorted({setting.node for setting in self._left_over})
                are_restored = [self._restore_node(node) for node in nodes]
            wait_s = _RETRY_S if all(are_restored) else min(2.0 * wait_s, _LONGEST_RETRY_S)
            self._is_closing.wait(wait_s)

    def _save(self) -> None:
        record = to_record(self._held) + [
            {"node": setting.node, "name": setting.name, "former": setting.value} for setting in self._left_over
        ]
        self._record.save(record)

    def _reconfigure(self, node: str, values: Dict[str, Value]) -> Dict[str, Value]:
        """Change settings of a node, none for empty values; returns all of its settings."""
        service = f"{node}/set_parameters"

        def ask() -> Dict[str, Value]:
            rospy.wait_for_service(service, timeout=self._timeout_s)
            return _values(rospy.ServiceProxy(service, Reconfigure)(_config(values)).config)

        return _ask_within(self._timeout_s + 0.5, ask, node)
