"""Userdata: named values that states share, and the view of them that one state gets."""

import copy
import enum
import types
from typing import Any, Dict, FrozenSet, Iterable, List, Mapping, Optional, SupportsIndex

from smach.exceptions import InvalidUserCodeError
from smach.log import logerr


class MissingKeyError(KeyError, AttributeError):
    """Userdata holds no value of that key; a KeyError for whoever uses brackets, an AttributeError for hasattr."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class UserData:
    """Named values, read and written as attributes or with brackets.

    Names that begin with an underscore belong to the object, not to the data.
    """

    def __init__(self) -> None:
        object.__setattr__(self, "_data", {})

    def update(self, ud: "UserData") -> None:
        """Take over every value of another userdata."""
        self._data.update(ud._data)

    def extract(self, keys: Iterable[str], remapping: Mapping[str, str]) -> "UserData":
        """Copy values to a new userdata under other names.

        Args:
            keys: names here
            remapping: from a name in the new userdata to the name here, where they differ
        """
        new_names = {name_here: new_name for new_name, name_here in remapping.items()}
        extracted = UserData()
        for key in keys:
            extracted[new_names.get(key, key)] = copy.copy(self[key])
        return extracted

    def merge(self, ud: "UserData", keys: Iterable[str], remapping: Mapping[str, str]) -> None:
        """Copy values from another userdata under other names.

        Args:
            ud: where the values come from
            keys: names in `ud`
            remapping: from a name in `ud` to the name here, where they differ
        """
        for key in keys:
            self[remapping.get(key, key)] = copy.copy(ud[key])

    def keys(self) -> List[str]:
        """Names that have a value now."""
        return list(self._data)

    def __contains__(self, key: str) -> bool:
        return key in self._data

    def __getitem__(self, key: str) -> Any:
        try:
            return self._data[key]
        except KeyError:
            raise MissingKeyError(f"userdata has no key '{key}'; it has: {sorted(map(str, self._data))}") from None

    def __setitem__(self, key: str, item: Any) -> None:
        self._data[key] = item

    def __getattr__(self, name: str) -> Any:
        # Reached only for what the object itself does not have; copy and pickle ask for many such names.
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            object.__setattr__(self, name, value)
        else:
            self[name] = value

    def __repr__(self) -> str:
        return f"UserData({self._data!r})"


class Remapper:
    """What one state sees of the userdata of its container.

    Input keys can be read, output keys can be written, under the names that the state uses. To write another key is a
    mistake that is logged; nothing is written. What is not an output comes as a view that cannot be changed; see
    get_const.

    Args:
        ud: userdata of the container
        input_keys: names that may be read
        output_keys: names that may be written
        remapping: from a name of the state to the name in `ud`, where they differ
    """

    _input_keys: FrozenSet[str]
    _output_keys: FrozenSet[str]
    _remapping: Dict[str, str]

    def __init__(
        self,
        ud: Any,
        input_keys: Iterable[str] = (),
        output_keys: Iterable[str] = (),
        remapping: Optional[Mapping[str, str]] = None,
    ) -> None:
        object.__setattr__(self, "_ud", ud)
        object.__setattr__(self, "_input_keys", frozenset(input_keys))
        object.__setattr__(self, "_output_keys", frozenset(output_keys))
        object.__setattr__(self, "_remapping", dict(remapping or {}))

    def _remap(self, key: str) -> str:
        return self._remapping.get(key, key)

    def __getitem__(self, key: str) -> Any:
        if key not in self._input_keys:
            raise InvalidUserCodeError(
                f"Reading userdata key '{key}', but the only input keys that this state declared are: "
                f"{sorted(self._input_keys)}"
            )
        value = self._ud[self._remap(key)]
        return value if key in self._output_keys else get_const(value)

    def __setitem__(self, key: str, value: Any) -> None:
        if key not in self._output_keys:
            logerr(
                f"Userdata key '{key}' is not written: the only output keys that this state declared are: "
                f"{sorted(self._output_keys)}"
            )
            return
        self._ud[self._remap(key)] = value

    def keys(self) -> List[str]:
        """Input keys that have a value now."""
        return [key for key in self._input_keys if self._remap(key) in self._ud]

    def update(self, ud: UserData) -> None:
        """Write every value of another userdata, as far as the names are output keys."""
        for key in ud.keys():
            self[key] = ud[key]

    def __contains__(self, key: str) -> bool:
        return key in self._input_keys and self._remap(key) in self._ud

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            object.__setattr__(self, name, value)
        else:
            self[name] = value


# States do not share values by the attributes of these types, or the types compare by identity, unlike a view.
_NEVER_VIEWED = (type, types.ModuleType, types.FunctionType, types.BuiltinFunctionType, types.MethodType, enum.Enum)


def get_const(obj: Any) -> Any:
    """View an object so that its attributes and items cannot be set or deleted.

    Only objects with attributes of their own (a `__dict__`) are viewed; numbers, texts, lists, dictionaries and ROS
    messages are returned as they are. The view passes for the object in isinstance() and compares like it.
    """
    if not hasattr(obj, "__dict__") or isinstance(obj, _NEVER_VIEWED) or type(obj) is Const:
        return obj
    return Const(obj)


def _forward(name: str) -> Any:
    def call(self: "Const", *args: Any) -> Any:
        # A viewed operand is compared as what it stands for.
        plain = [object.__getattribute__(arg, "_obj") if type(arg) is Const else arg for arg in args]
        return getattr(type(self._obj), name)(self._obj, *plain)

    call.__name__ = name
    return call


class Const:
    """A view of an object that refuses to change it; made by get_const."""

    __slots__ = ("_obj",)

    def __init__(self, obj: Any) -> None:
        object.__setattr__(self, "_obj", obj)

    def __getattribute__(self, name: str) -> Any:
        obj = object.__getattribute__(self, "_obj")
        return obj if name == "_obj" else get_const(getattr(obj, name))

    def __setattr__(self, name: str, value: Any) -> None:
        raise TypeError(f"'{name}' cannot be set: the value is an input of this state and not an output")

    def __delattr__(self, name: str) -> None:
        raise TypeError(f"'{name}' cannot be deleted: the value is an input of this state and not an output")

    def __getitem__(self, key: Any) -> Any:
        return get_const(self._obj[key])

    def __setitem__(self, key: Any, value: Any) -> None:
        raise TypeError(f"item {key!r} cannot be set: the value is an input of this state and not an output")

    def __delitem__(self, key: Any) -> None:
        raise TypeError(f"item {key!r} cannot be deleted: the value is an input of this state and not an output")

    def __iter__(self) -> Any:
        return (get_const(item) for item in self._obj)

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        return self._obj(*args, **kwargs)

    def __copy__(self) -> Any:
        return copy.copy(self._obj)

    def __deepcopy__(self, memo: Dict[int, Any]) -> Any:
        return copy.deepcopy(self._obj, memo)

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        return self._obj.__reduce_ex__(protocol)

    def __bool__(self) -> bool:
        return bool(self._obj)


for _name in (
    "__eq__",
    "__ne__",
    "__lt__",
    "__le__",
    "__gt__",
    "__ge__",
    "__hash__",
    "__len__",
    "__contains__",
    "__str__",
    "__repr__",
    "__add__",
    "__sub__",
    "__mul__",
    "__truediv__",
    "__neg__",
    "__abs__",
    "__int__",
    "__float__",
    "__index__",
    "__format__",
):
    setattr(Const, _name, _forward(_name))
del _name
