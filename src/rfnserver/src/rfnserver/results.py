"""Reads the result of an action or the response of a service: whether it worked, and why not.

By convention, a bool :data:`SUCCESS_FIELDS`, or an integer :data:`ERROR_FIELDS` whose message declares the constant of
success, says whether it worked, and the first string of :data:`TEXT_FIELDS` that is not empty says why not. A program
or a file may name other fields, see :class:`ResultNames`.
"""

import difflib
from dataclasses import dataclass, field, replace
from typing import Any, Container, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from rfnserver.goal_types import Filling, GoalField

SUCCESS_FIELDS = ("success", "is_success", "succeeded")
TEXT_FIELDS = ("error_string", "message", "text", "status")
ERROR_FIELDS = ("error_code", "error_code.val", "outcome")
#: Names of the constant of success.
OK_CONSTANTS = ("SUCCESS", "SUCCESSFUL", "SUCCEEDED", "OK", "NO_ERROR")
ERROR_KEYS = ("name", "ok")


class ResultError(ValueError):
    """The named fields do not fit the result; the message names key, field and what there is."""


@dataclass(frozen=True)
class ResultNames:
    """The fields of a result that are read. None: by convention. An empty name: no field.

    Attributes:
        success_field: path of a bool
        text_field: path of a string: the reason of a failure, and the answer to the person after a success
        error_field: path of an error code, or ``{"name": path, "ok": value}``; without ``ok`` the value is that of the
            constant of success, or else 0
    """

    success_field: Optional[str] = None
    text_field: Optional[str] = None
    error_field: Optional[Union[str, Mapping[str, Any]]] = None


BY_CONVENTION = ResultNames()
#: The status of the goal says it alone: of frames, whose result servers of 2012 leave empty.
BY_STATUS = ResultNames(success_field="", text_field="", error_field="")


@dataclass(frozen=True)
class ResultVerdict:
    """What a result says.

    Attributes:
        is_done: whether it worked
        text: of a field that was named for it; empty for none
        reason: of a failure, by convention; empty for none
    """

    is_done: bool = True
    text: str = ""
    reason: str = ""


@dataclass(frozen=True)
class ResultPlan:
    """Which fields of a result are read.

    Attributes:
        success: path of the bool; empty for none
        error: path of the error code; empty for none
        ok: its value after a success
        errors: names of the other values
        text: path of the string that was named; empty for none
        reasons: paths of strings that may say why it failed
    """

    success: str = ""
    error: str = ""
    ok: str = "0"
    errors: Mapping[str, str] = field(default_factory=dict)
    text: str = ""
    reasons: Tuple[str, ...] = ()

    def read(self, result: Any) -> ResultVerdict:
        """Return what a result says; None, for no result, says nothing."""
        if result is None:
            return ResultVerdict()
        code = str(_at(result, self.error)) if self.error else self.ok
        is_done = code == self.ok and (not self.success or bool(_at(result, self.success)))
        said = (str(_at(result, path)).strip() for path in self.reasons)
        reason = next(filter(None, said), "") or (self.errors.get(code, f"error {code}") if code != self.ok else "")
        return ResultVerdict(is_done, str(_at(result, self.text)).strip() if self.text else "", reason)


def _at(result: Any, path: str) -> Any:
    for name in path.split("."):
        result = getattr(result, name)
    return result


def plan_result(fields: Sequence[GoalField], names: ResultNames = BY_CONVENTION) -> ResultPlan:
    """Decide which fields of a result are read. Where one of success and error is named, the other is not guessed.

    Args:
        fields: every field of the result, including those of nested messages
        names: of the fields; by convention where they are None
    Raises:
        ResultError: a named field does not exist, or is of another type
    """
    plain = {one.path: one for one in fields if one.filling is not None and not one.is_list}
    is_named = names.success_field is not None or names.error_field is not None
    plan = ResultPlan(reasons=tuple(_of_type(plain, TEXT_FIELDS, (Filling.STRING,))))
    if names.success_field:
        plan = replace(plan, success=_named("success_field", names.success_field, plain, (Filling.BOOLEAN,)).path)
    elif not is_named:
        plan = replace(plan, success=next(_of_type(plain, SUCCESS_FIELDS, (Filling.BOOLEAN,)), ""))
    if names.error_field:
        plan = _with_error(plan, names.error_field, plain)
    elif not is_named:
        for path in _of_type(plain, ERROR_FIELDS, (Filling.INTEGER,)):
            if _ok_constant(plain[path]) is not None:
                plan = _with_error(plan, path, plain)
                break
    if names.text_field is not None:
        plan = replace(plan, reasons=())
    if names.text_field:
        plan = replace(plan, text=_named("text_field", names.text_field, plain, (Filling.STRING,)).path)
    return plan


def _of_type(plain: Mapping[str, GoalField], paths: Iterable[str], fillings: Container[Optional[Filling]]) -> Any:
    return (path for path in paths if path in plain and plain[path].filling in fillings)


def _with_error(
    plan: ResultPlan, declared: Union[str, Mapping[str, Any]], plain: Mapping[str, GoalField]
) -> ResultPlan:
    entry = {"name": declared} if isinstance(declared, str) else dict(declared)
    unknown = [str(key) for key in entry if key not in ERROR_KEYS]
    if unknown or not entry.get("name"):
        found = f"the key {', '.join(unknown)}" if unknown else "no name"
        raise ResultError(f"error_field: expected {' and '.join(ERROR_KEYS)}, found {found}")
    one = _named("error_field", str(entry["name"]), plain, (Filling.INTEGER, Filling.STRING))
    ok = entry.get("ok", _ok_constant(one))
    if ok is None:
        ok = 0 if one.filling is Filling.INTEGER else ""
    values = {name: value for name, value in one.constants.items() if type(value) in (int, str)}
    errors = {str(value): name.lower().replace("_", " ") for name, value in values.items() if str(value) != str(ok)}
    return replace(plan, error=one.path, ok=str(ok), errors=errors)


def _ok_constant(one: GoalField) -> Optional[Any]:
    return next((one.constants[name] for name in OK_CONSTANTS if name in one.constants), None)


def _named(key: str, path: str, plain: Mapping[str, GoalField], fillings: Container[Optional[Filling]]) -> GoalField:
    one = plain.get(path)
    fitting: List[str] = list(_of_type(plain, plain, fillings))
    if one is not None and one.path in fitting:
        return one
    found = f"'{path}' is a {one.type_name}" if one is not None else f"there is no field '{path}'"
    alike = difflib.get_close_matches(path, fitting, n=1)
    hint = f"; did you mean '{alike[0]}'?" if alike else ""
    raise ResultError(f"{key}: {found}, expected one of {', '.join(fitting) or 'none'}{hint}")
