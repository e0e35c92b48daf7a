"""Reads clauses that name no deed and no state of their own: "if it is not", "if that fails", "when you are done".

They say in which case, or when, something is done, and mean the deed or the condition before them.
"""

from enum import Enum
from typing import AbstractSet, NamedTuple, Optional, Sequence

from word_classes import word_class

_HEARERS = word_class("hearers")
_NOT = word_class("not")
_BEING = word_class("forms_of_be") | {"'s", "'re"}
_DOING = word_class("forms_of_do")
_HAVING = word_class("forms_of_have") | {"'ve"}
_ABLE = frozenset(["can", "ca"])
_THINGS = frozenset(["it", "they"])
_PERSONS = frozenset(["he", "she"])
_DEEDS = word_class("pronouns_of_things")
_FOUND = word_class("object_pronouns") | {"one", "any"}
_DONE = frozenset(["done", "finished"])
_SOME = word_class("indefinite_articles") | {"one"}
_WHEN = frozenset(["when", "once"])


class Case(Enum):
    """What a clause says of the deed or the condition before it."""

    HOLDS = "holds"  # "if so"
    HOLDS_NOT = "holds_not"  # "if it is not"
    FAILED = "failed"  # "if that fails"
    DONE = "done"  # "when you are done"
    GOES_ON = "goes_on"  # "while you do that"


class EllipticClause(NamedTuple):
    """A clause without a deed or a state of its own.

    Attributes:
        case: what it says
        length: number of its words, the conjunction included
    """

    case: Case
    length: int


def elliptic_clause(forms: Sequence[str]) -> Optional[EllipticClause]:
    """Return the longest such clause that words in lower case begin with; None if they begin with another clause."""
    if not forms:
        return None
    if forms[0] == "if":
        return _Words(forms, 1).case()
    if forms[0] == "while":
        return _Words(forms, 1).going_on()
    if list(forms[:3]) == ["as", "soon", "as"]:
        return _Words(forms, 3).done()
    return _Words(forms, 1).done() if forms[0] in _WHEN or forms[0] == "after" else None


class _Words:
    """Words that are read from left to right."""

    def __init__(self, forms: Sequence[str], place: int) -> None:
        self._forms = forms
        self._place = place

    def _takes(self, *classes: AbstractSet[str]) -> bool:
        """Read words of some classes, one of each; read none if they are others."""
        said = self._forms[self._place : self._place + len(classes)]
        is_said = len(said) == len(classes) and all(form in one for form, one in zip(said, classes))
        self._place += len(classes) * is_said
        return is_said

    def _found(self, case: Case) -> EllipticClause:
        return EllipticClause(case, self._place)

    def case(self) -> Optional[EllipticClause]:
        """Read a clause behind "if"."""
        if self._takes({"so", "yes"}):
            self._takes({"then"})
            return self._found(Case.HOLDS)
        if self._takes(_NOT):
            return self._found(Case.HOLDS_NOT)
        if self._takes(_DEEDS, _BEING, {"the"}, {"case"}):
            return self._found(Case.HOLDS)
        if self._takes(_DEEDS, {"fails"}) or self._takes(_HEARERS, {"fail"}):
            return self._found(Case.FAILED)
        if self._takes({"there"}, _BEING):
            return self._existence()
        if self._takes(_HEARERS, _DOING | _ABLE) or self._takes(_HEARERS, {"cannot"}):
            return self._success()
        if self._takes(_DEEDS | {"they"}, _DOING, _NOT, {"work"}):
            return self._found(Case.FAILED)
        if self._takes(_DEEDS, _BEING, _NOT, {"possible"}) or self._takes(_THINGS, _BEING, _NOT, {"there"}):
            return self._found(Case.FAILED)
        if self._takes(_THINGS | _PERSONS, _BEING, _NOT):
            return self._found(Case.HOLDS_NOT)
        if self._takes(_THINGS | _PERSONS, _BEING):
            self._takes({"there"})
            return self._before_comma()
        return self._before_comma() if self._takes(_THINGS | _PERSONS, _DOING) else None

    def _existence(self) -> Optional[EllipticClause]:
        if self._takes({"none"}):
            return self._found(Case.FAILED)
        self._takes(_SOME)
        return self._before_comma()

    def _success(self) -> Optional[EllipticClause]:
        """Read what is behind "if you can", "if you do": "n't find it"."""
        is_ability = self._forms[self._place - 1] not in _DOING
        is_denied = self._forms[self._place - 1] == "cannot" or self._takes(_NOT)
        if not is_denied:
            return self._before_comma()
        is_found = self._takes({"find"}, _FOUND)
        return self._found(Case.FAILED) if is_found or is_ability else None

    def _before_comma(self) -> Optional[EllipticClause]:
        """Without the comma, a condition of its own may follow: "if it is open"."""
        return self._found(Case.HOLDS) if self._takes({","}) else None

    def done(self) -> Optional[EllipticClause]:
        """Read a clause behind "when": "you are done with that", "that is done"."""
        if self._takes(_DEEDS, _BEING, _DONE) or self._takes(_HEARERS, _HAVING, {"done"}, _DEEDS):
            return self._found(Case.DONE)
        if not self._takes(_HEARERS, _BEING | _HAVING, _DONE | {"ready"}):
            return None
        self._takes({"with"}, _DEEDS)
        return self._found(Case.DONE)

    def going_on(self) -> Optional[EllipticClause]:
        """Read a clause behind "while": "you do that", "doing so"."""
        if self._takes(_HEARERS, _BEING, {"at"}, {"it"}):
            return self._found(Case.GOES_ON)
        is_said = self._takes(_HEARERS, _BEING, {"doing"}) or self._takes(_HEARERS, {"do"}) or self._takes({"doing"})
        return self._found(Case.GOES_ON) if is_said and self._takes(_DEEDS | {"so"}) else None
