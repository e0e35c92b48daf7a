"""Classes of English words that more than one pass, or a pass and the framer, look at."""

import re

#: Said while thinking, as long as it takes ("uhhh"); never a part of what is said.
_FILLER = re.compile(r"(u+h+m*|u+m+|e+r+m*|e+h+|e+h*m+|h+m+|m{2,})$")
HEDGES = frozenset(["maybe", "perhaps", "possibly"])
#: Said around a command without changing it.
HARMLESS = (
    frozenset(
        "please now just kindly then also okay ok so well hey hi hello robot again next first finally simply actually "
        "thanks thank could can would will you i us lets alright".split()
    )
    | HEDGES
)
#: Words that may stand before the verb of a command, with a comma or without.
LEAD_IN = frozenset(
    "please now ok okay so well uh um hey hi hello then and robot just kindly also next first finally".split()
)
NEGATIONS = frozenset("not never n't no dont don't neither nor nobody noone none nothing".split())
#: Subordinators that make an action depend on something, or put it off.
CONDITIONS = frozenset("if when until till unless once after before while whenever as".split())
#: Verbs that wrap a request: "I want you to ...", "would you mind ...ing", "could you try to ...".
WRAPPERS = frozenset("want need like mind wish try remember ask love prefer let have help".split())
#: A phrase with one of these says where a thing is. If it fills no element of the unit, it belongs to the noun that it
#: stands behind, even where the parser hung it on the verb: "bring the mug on the table".
OF_PLACE = frozenset(
    "on in at near under behind beside beneath below above over inside outside between against by next close around "
    "of".split()
)
#: "A bit", "a little": how much of what the verb says.
DEGREES = frozenset(["bit", "little", "tad"])


def is_filler(form: str) -> bool:
    """Whether a word is said only while thinking: "um", "uhhh"."""
    return _FILLER.match(form.lower()) is not None
