"""Settings that servers need while they work, such as the exposure of a camera.

A setting belongs to a node that can be reconfigured. The settings of a server are applied before its step, and
the former values are restored after it.
"""

import math
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

Value = Union[bool, int, float, str]


class SettingsError(ValueError):
    """Settings cannot be read or applied, or two steps need different values; the text says which and why."""


@dataclass(frozen=True)
class Setting:
    """A value for one setting of one node.

    Attributes:
        node: resolved name of the node
        name: of the setting
        value: what it is set to
    """

    node: str
    name: str
    value: Value

    @property
    def place(self) -> Tuple[str, str]:
        """Node and name; two values for one place are in conflict."""
        return self.node, self.name


@dataclass(frozen=True)
class HeldSetting:
    """A setting that is applied now.

    Attributes:
        setting: what is applied
        former: the value before; it is restored when the last owner has finished
        owners: the steps that need it
    """

    setting: Setting
    former: Value
    owners: Tuple[str, ...]


def read_needs(found: object, *, server: str) -> Tuple[Setting, ...]:
    """Read the settings that a server needs.

    Args:
        found: a list of mappings with the keys ``node`` and ``settings``, a mapping of name to value; None for no
            needs. A list, because the parameter server takes a name with a slash as a key for a parameter of its own.
        server: its name, for the errors

    Raises:
        SettingsError: another shape, or a value that is no bool, finite number or string
    """
    if found is None:
        return ()
    if not isinstance(found, (list, tuple)):
        raise SettingsError(f"required_settings of {server}: expected a list, found {found!r}")
    needs: List[Setting] = []
    for entry in found:
        if not (
            isinstance(entry, Mapping)
            and set(entry) == {"node", "settings"}
            and isinstance(entry["settings"], Mapping)
            and isinstance(entry["node"], str)
            and entry["node"]
        ):
            raise SettingsError(f"required_settings of {server}: expected node and a mapping settings, found {entry!r}")
        for name, value in entry["settings"].items():
            is_number = isinstance(value, (int, float)) and math.isfinite(value)
            if not (isinstance(value, (bool, str)) or is_number):
                raise SettingsError(
                    f"required_settings of {server}, {entry['node']}, {name}: expected a bool, "
                    f"a number or a string, found {value!r}"
                )
            needs.append(Setting(node=entry["node"], name=str(name), value=value))
    return tuple(needs)


def check_needs(needs: Sequence[Setting], held: Mapping[Tuple[str, str], HeldSetting]) -> None:
    """Check that needs agree with each other and with the settings that are applied.

    Args:
        needs: of one step, with resolved names of nodes
        held: what other steps have applied

    Raises:
        SettingsError: two values for one setting
    """
    wanted: Dict[Tuple[str, str], Value] = {}
    for setting in needs:
        if wanted.setdefault(setting.place, setting.value) != setting.value:
            raise SettingsError(
                f"{setting.name} of {setting.node} must be {wanted[setting.place]!r} and {setting.value!r} at once"
            )
        other = held.get(setting.place)
        if other is not None and other.setting.value != setting.value:
            raise SettingsError(
                f"{setting.name} of {setting.node} must be {setting.value!r}, but "
                f"{', '.join(other.owners)} needs {other.setting.value!r}"
            )


def fit_value(setting: Setting, current: Value) -> Value:
    """Convert a value to the type that the node has for it.

    Raises:
        SettingsError: it cannot be converted, such as "fast" to a number
    """
    value = setting.value
    if isinstance(current, bool) or isinstance(value, bool):
        fits = isinstance(current, bool) and isinstance(value, bool)
        fitted: Value = value
    elif isinstance(current, str) or isinstance(value, str):
        fits = isinstance(current, str) and isinstance(value, str)
        fitted = value
    elif isinstance(current, int):
        fits = float(value) == int(value)
        fitted = int(value)
    else:
        fits, fitted = True, float(value)
    if not fits:
        raise SettingsError(f"{setting.name} of {setting.node} takes {type(current).__name__}, found {setting.value!r}")
    return fitted


def to_record(held: Mapping[Tuple[str, str], HeldSetting]) -> List[Dict[str, Value]]:
    """The former values, which must outlive the executor."""
    return [{"node": entry.setting.node, "name": entry.setting.name, "former": entry.former} for entry in held.values()]


def from_record(found: Any) -> Tuple[Setting, ...]:
    """The former values that a record holds, as settings to apply.

    Raises:
        SettingsError: another shape
    """
    if found is None:
        return ()
    try:
        return tuple(
            Setting(node=str(entry["node"]), name=str(entry["name"]), value=entry["former"]) for entry in found
        )
    except (KeyError, TypeError) as error:
        raise SettingsError(f"the record of settings cannot be read: {error!r}") from error


def unknown_setting(setting: Setting, known: Sequence[str]) -> SettingsError:
    """The error for a setting that the node does not have."""
    return SettingsError(f"{setting.node} has no setting {setting.name}; it has {', '.join(sorted(known)) or 'none'}")


def differs(wanted: Value, found: Optional[Value]) -> bool:
    """Whether the node took another value, for example because of its range."""
    if isinstance(wanted, float) and isinstance(found, float):
        return not math.isclose(wanted, found, rel_tol=1e-9, abs_tol=1e-12)
    return wanted != found
