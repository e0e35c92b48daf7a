"""A small grammar of English: forms of verbs, noun phrases, and clauses around a verb.

It imports nothing of the project, so that a mistake of the framer is not a mistake of the right answers.
"""

import re
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any, List, Mapping

import yaml

_VOWELS = "aeiou"
_PHRASE_END = re.compile(r"[.!?]$")


@lru_cache(maxsize=1)
def words() -> Mapping[str, Any]:
    """Return the word lists of ``english.yaml``, by name."""
    text = Path(__file__).resolve().with_name("english.yaml").read_text(encoding="utf-8")
    found: Mapping[str, Any] = yaml.safe_load(text)
    return found


def past_of(verb: str) -> str:
    """Return the past of a verb: "closed", "took"."""
    irregular = words()["irregular"].get(verb)
    if irregular is not None:
        return str(irregular if isinstance(irregular, str) else irregular[0])
    return _with_ed(verb)


def participle_of(verb: str) -> str:
    """Return the past participle of a verb: "closed", "taken"."""
    irregular = words()["irregular"].get(verb)
    if irregular is not None:
        return str(irregular if isinstance(irregular, str) else irregular[1])
    return _with_ed(verb)


def third_of(verb: str) -> str:
    """Return the third person of a verb: "closes", "carries"."""
    known = words()["third_persons"].get(verb)
    if known is not None:
        return str(known)
    if _ends_in_consonant_y(verb):
        return verb[:-1] + "ies"
    return verb + ("es" if verb.endswith(("s", "x", "z", "ch", "sh")) else "s")


def gerund_of(verb: str) -> str:
    """Return the gerund of a verb: "closing", "putting"."""
    known = words()["gerunds"].get(verb)
    if known is not None:
        return str(known)
    if verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")):
        return verb[:-1] + "ing"
    return _doubled(verb) + "ing"


def _with_ed(verb: str) -> str:
    if verb.endswith("e"):
        return verb + "d"
    if _ends_in_consonant_y(verb):
        return verb[:-1] + "ied"
    return _doubled(verb) + "ed"


def _ends_in_consonant_y(word: str) -> bool:
    return len(word) > 1 and word.endswith("y") and word[-2] not in _VOWELS


def _doubled(verb: str) -> str:
    """Double the last letter of a verb that is stressed on its last syllable, which is short: "stop", "unplug"."""
    is_short = re.search(r"(^|[^aeiou]|qu)[aeiou][^aeiouwxy]$", verb) is not None
    is_stressed = len(re.findall(r"[aeiouy]+", verb.replace("qu", "q"))) == 1 or verb in words()["stressed_at_end"]
    return verb + verb[-1] if is_short and is_stressed else verb


@dataclass(frozen=True)
class NounPhrase:
    """A noun phrase, as it was said: "the vase on the floor"."""

    text: str

    @property
    def determiner(self) -> str:
        """Its first word, if that is a determiner."""
        first = self.text.split()[0].lower()
        return first if first in words()["determiners"] else ""

    @property
    def without_determiner(self) -> str:
        """The phrase without its determiner: "vase on the floor"."""
        return self.text.split(maxsplit=1)[1] if self.determiner and " " in self.text else self.text

    @property
    def core(self) -> str:
        """The phrase up to its head: "vase"."""
        found: List[str] = []
        for word in self.without_determiner.split():
            if found and word in words()["prepositions"]:
                break
            found.append(word)
        return " ".join(found)

    @property
    def head(self) -> str:
        """Its noun."""
        return self.core.split()[-1]

    @property
    def is_pronoun(self) -> bool:
        """Whether it is a pronoun."""
        names = ("personal_pronouns", "pointing", "pointing_alone")
        return any(self.text.lower() in words()[name] for name in names)

    @property
    def is_name(self) -> bool:
        """Whether it is the name of a person."""
        return self.head[:1].isupper() and not self.determiner

    @property
    def is_person(self) -> bool:
        """Whether one asks for it with "who"."""
        return self.is_name or self.head.lower() in words()["persons"] or self.text in ("me", "us")

    @property
    def is_mass(self) -> bool:
        """Whether its noun has no plural."""
        return self.head in words()["masses"]

    @property
    def is_plural(self) -> bool:
        """Whether it is in the plural."""
        head = self.head
        if head in words()["plurals_without_s"]:
            return True
        return head.endswith("s") and head not in words()["singulars_in_s"] and not self.is_name

    @property
    def is_whole(self) -> bool:
        """Whether nothing follows its noun."""
        return self.core == self.without_determiner

    @property
    def is_place(self) -> bool:
        """Whether one can go to it, or to where it is."""
        return not self.is_pronoun and self.head.lower() not in words()["not_places"]

    @property
    def kind(self) -> str:
        """The kind of what it names, in the plural: "doors"; "soup" for what has no plural."""
        if self.is_name:
            return "people"
        before, _, head = self.core.rpartition(" ")
        before = " ".join(word for word in before.split() if word not in words()["numbers"])
        plural = head if self.is_plural or self.is_mass else plural_of(head)
        return f"{before} {plural}".strip()

    @property
    def definite(self) -> str:
        """The phrase for something that is known: "the door"; "the person" for a name."""
        return "the person" if self.is_name else f"the {self.without_determiner}"


def plural_of(noun: str) -> str:
    """Return the plural of a noun."""
    known = words()["plurals"].get(noun)
    if known is not None:
        return str(known)
    if _ends_in_consonant_y(noun):
        return noun[:-1] + "ies"
    return noun + ("es" if noun.endswith(("s", "x", "z", "ch", "sh")) else "s")


@dataclass(frozen=True)
class Predicate:
    """A verb with what belongs to it: "pour | me | a beer | into the glass".

    Attributes:
        verb: one word, the base form
        particle: what stands between the verb and its objects: "up", "care of"
        receiver: the indirect object
        object: the direct object; empty if it has none, or one that is no argument
        rest: what follows
    """

    verb: str
    particle: str = ""
    receiver: str = ""
    object: str = ""
    rest: str = ""

    def said(self, form: str, *, gap: str = "") -> str:
        """Return the predicate around a form of its verb.

        Args:
            form: of the verb, "closed"
            gap: attribute that is left out, because it is said elsewhere: "object"
        """
        shown = replace(self, **{gap: ""}) if gap else self
        return _joined(form, shown.particle, shown.receiver, shown.object, shown.rest)

    def base(self, *, gap: str = "") -> str:
        """Return "close the door"; see :meth:`said`."""
        return self.said(self.verb, gap=gap)

    def third(self, *, gap: str = "") -> str:
        """Return "closes the door"; see :meth:`said`."""
        return self.said(third_of(self.verb), gap=gap)

    def past(self, *, gap: str = "") -> str:
        """Return "closed the door"; see :meth:`said`."""
        return self.said(past_of(self.verb), gap=gap)

    def participle(self, *, gap: str = "") -> str:
        """Return "closed the door", after "have"; see :meth:`said`."""
        return self.said(participle_of(self.verb), gap=gap)

    def gerund(self, *, gap: str = "") -> str:
        """Return "closing the door"; see :meth:`said`."""
        return self.said(gerund_of(self.verb), gap=gap)

    @property
    def passive_subject(self) -> str:
        """The subject of its passive; empty if there is no good one."""
        if not self.object or NounPhrase(self.object).is_pronoun or self._is_motion:
            return ""
        if self.receiver and not self._preposition:
            return "" if NounPhrase(self.receiver).is_pronoun else self.receiver
        return self.object

    @property
    def _is_motion(self) -> bool:
        return bool(self.particle) and self.verb in words()["no_passive"]

    @property
    def _preposition(self) -> str:
        """The preposition with which the receiver comes back in the passive: "handed to me"."""
        for preposition in ("to", "for"):
            if self.verb in words()[f"receivers_with_{preposition}"]:
                return preposition
        return ""

    def passive(self, form: str) -> str:
        """Return what follows the subject of the passive: "switched on", "handed to me", "asked a question".

        Args:
            form: of the verb, the participle; or the gerund after "needs"
        """
        if self.passive_subject == self.receiver and self.receiver:
            return _joined(form, self.particle, self.object, self.rest)
        receiver = f"{self._preposition} {self.receiver}" if self.receiver else ""
        return _joined(form, self.particle, receiver, self.rest)

    def said_of(self, others: str) -> "Predicate":
        """Return the predicate for another agent than the robot: "introduces herself".

        Args:
            others: name of the word list that says what "your" becomes
        """
        changes: Mapping[str, str] = words()[others]

        def changed(text: str) -> str:
            return " ".join(changes.get(word, word) for word in text.split())

        return Predicate(
            self.verb, changed(self.particle), changed(self.receiver), changed(self.object), changed(self.rest)
        )


def _joined(*parts: str) -> str:
    return " ".join(part for part in parts if part)


def sentence(text: str, mark: str = ".") -> str:
    """Return a text with a capital at its beginning and a mark at its end."""
    return _PHRASE_END.sub("", text[:1].upper() + text[1:]) + mark
