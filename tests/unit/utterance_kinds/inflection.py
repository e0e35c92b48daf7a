"""Inflects the verb at the beginning of a clause: "pick up the box" becomes "picked up the box"."""

from dataclasses import dataclass
from typing import Dict, Tuple

#: Past and past participle of irregular verbs.
_IRREGULAR: Dict[str, Tuple[str, str]] = {
    "be": ("was", "been"),
    "bear": ("bore", "borne"),
    "bind": ("bound", "bound"),
    "bring": ("brought", "brought"),
    "catch": ("caught", "caught"),
    "come": ("came", "come"),
    "cut": ("cut", "cut"),
    "deal": ("dealt", "dealt"),
    "drive": ("drove", "driven"),
    "find": ("found", "found"),
    "freeze": ("froze", "frozen"),
    "get": ("got", "gotten"),
    "give": ("gave", "given"),
    "go": ("went", "gone"),
    "hang": ("hung", "hung"),
    "have": ("had", "had"),
    "hold": ("held", "held"),
    "keep": ("kept", "kept"),
    "lay": ("laid", "laid"),
    "lead": ("led", "led"),
    "leave": ("left", "left"),
    "let": ("let", "let"),
    "lie": ("lay", "lain"),
    "make": ("made", "made"),
    "put": ("put", "put"),
    "quit": ("quit", "quit"),
    "ride": ("rode", "ridden"),
    "run": ("ran", "run"),
    "say": ("said", "said"),
    "see": ("saw", "seen"),
    "seek": ("sought", "sought"),
    "send": ("sent", "sent"),
    "set": ("set", "set"),
    "shoot": ("shot", "shot"),
    "show": ("showed", "shown"),
    "shut": ("shut", "shut"),
    "sit": ("sat", "sat"),
    "speak": ("spoke", "spoken"),
    "spin": ("spun", "spun"),
    "stand": ("stood", "stood"),
    "stick": ("stuck", "stuck"),
    "sweep": ("swept", "swept"),
    "swing": ("swung", "swung"),
    "take": ("took", "taken"),
    "tell": ("told", "told"),
    "throw": ("threw", "thrown"),
    "withdraw": ("withdrew", "withdrawn"),
}
#: Verbs that double their last letter before "ed" and "ing": one short syllable, or the stress on the last.
_DOUBLING = frozenset(
    "chop clap control dim drop fit flip get grab grip hop hug hum jog let mop nod pat pin plan plug put quit run scan "
    "scrub set ship shop shut sit skin slip snap spin spot stir stop strap swim swap tap tip trim trip unplug wrap zip "
    "cut dig hit rub stem step top trot wag ".split()
)
#: Irregular gerunds.
_GERUNDS = {"tie": "tying", "untie": "untying", "lie": "lying", "be": "being", "see": "seeing"}
_VOWELS = "aeiou"


@dataclass(frozen=True)
class Forms:
    """The forms of a verb, or of a clause that begins with it, for the slots of a template."""

    base: str
    third: str
    past: str
    participle: str
    gerund: str


def inflect(verb: str) -> Forms:
    """Return the forms of a verb: one word in lower case."""
    past, participle = _IRREGULAR.get(verb, (_past(verb), _past(verb)))
    return Forms(verb, _third(verb), past, participle, _gerund(verb))


def inflect_clause(clause: str) -> Forms:
    """Return the forms of a clause whose first word is its verb; its other words do not change."""
    verb, _, rest = clause.partition(" ")
    forms = inflect(verb)
    if verb in ("high", "low"):  # "high five me": the second word is inflected
        second, _, rest = rest.partition(" ")
        five = inflect(second)
        forms = Forms(*(f"{verb} {form}" for form in (five.base, five.third, five.past, five.participle, five.gerund)))
    return Forms(
        *(f"{form} {rest}".strip() for form in (forms.base, forms.third, forms.past, forms.participle, forms.gerund))
    )


def _ends_in_consonant_y(verb: str) -> bool:
    return len(verb) > 1 and verb.endswith("y") and verb[-2] not in _VOWELS


def _third(verb: str) -> str:
    if verb in ("be", "have"):
        return {"be": "is", "have": "has"}[verb]
    if _ends_in_consonant_y(verb):
        return verb[:-1] + "ies"
    return verb + ("es" if verb.endswith(("s", "x", "z", "ch", "sh", "go", "do")) else "s")


def _past(verb: str) -> str:
    if verb.endswith("e"):
        return verb + "d"
    if _ends_in_consonant_y(verb):
        return verb[:-1] + "ied"
    return verb + (verb[-1] if verb in _DOUBLING else "") + "ed"


def _gerund(verb: str) -> str:
    if verb in _GERUNDS:
        return _GERUNDS[verb]
    if verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")):
        return verb[:-1] + "ing"
    return verb + (verb[-1] if verb in _DOUBLING else "") + "ing"
